# The results of the conformance tests (tests/conformance/results.hpp has the columns), sorted, to the
# Markdown of docs/conformance_scenes.md.

function cell(dialect, scene, format,    key) {
  key = dialect SUBSEP scene SUBSEP format
  if (!(key in differing)) return "not run"
  if (result[key] != "pass") return "**" steps[key] "/255, " differing[key] " px**"
  if (differing[key] == 0) return "identical"
  return steps[key] "/255, " differing[key] " px"
}

function row(scene) {
  return cell("core_330", scene, "RGBA8") " | " cell("core_330", scene, "float") " | " \
    cell("es_300", scene, "RGBA8") " | " cell("es_300", scene, "float")
}

{
  dialect = $1; feature = $2; name = $3; format = $4
  scene = feature "/" name
  key = dialect SUBSEP scene SUBSEP format
  steps[key] = sprintf("%.3g", $6)
  differing[key] = $7
  result[key] = $8

  random = feature ~ /^random_state/
  group = dialect SUBSEP (random ? "random" : "scene") SUBSEP format
  compared[group]++
  if ($7 == 0) identical[group]++
  if ($8 == "pass") passed[group]++
  if ($6 + 0 > largest[group] + 0) largest[group] = $6

  if (random || scene in judge) next
  judge[scene] = $5
  if (!(feature in scenes)) features[++feature_count] = feature
  scenes[feature, ++scenes[feature]] = name
}

END {
  print "# Conformance, scene by scene\n"
  print "Written by `scripts/conformance`. Each scene of `tests/conformance` is drawn by Mesa's fixed function"
  print "and by this library with the same calls, and the images are compared: RGBA8 within one step in every"
  print "pixel, float colours within 0.02/255, coverage identical. Where the judge is a row M of"
  print "`docs/deviations.md`, Mesa departs from the specification: the library's image is compared with Mesa's"
  print "of an equivalent scene that Mesa gets right.\n"
  print "| dialect | images | colours | compared | within tolerance | bit-identical | largest difference |"
  print "|---|---|---|---|---|---|---|"
  split("core_330 es_300", dialects, " ")
  split("scene random", kinds, " ")
  split("RGBA8 float", formats, " ")
  for (d = 1; d <= 2; d++)
    for (k = 1; k <= 2; k++)
      for (f = 1; f <= 2; f++) {
        group = dialects[d] SUBSEP kinds[k] SUBSEP formats[f]
        if (!(group in compared)) continue
        printf "| %s | %s | %s | %d | %d | %d | %.3g/255 |\n", dialects[d],
          kinds[k] == "scene" ? "named scenes" : "random states", formats[f], compared[group],
          passed[group], identical[group], largest[group]
      }
  for (i = 1; i <= feature_count; i++) {
    feature = features[i]
    print "\n## " feature "\n"
    print "| scene | judge | core 330, RGBA8 | core 330, float | ES 300, RGBA8 | ES 300, float |"
    print "|---|---|---|---|---|---|"
    for (j = 1; j <= scenes[feature]; j++) {
      name = feature "/" scenes[feature, j]
      print "| " scenes[feature, j] " | " judge[name] " | " row(name) " |"
    }
  }
}
