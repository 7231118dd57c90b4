-- lua5.4 measure.lua FOLDER TASK SECONDS: prints the median of the runs in ms, and the result.
local folder, task, seconds = arg[1], arg[2], tonumber(arg[3])
local run = dofile(folder .. "/" .. task .. ".lua")
local times, total, result = {}, 0, nil
while #times < 3 or total < seconds do
  local start = os.clock()
  result = run()
  local time = os.clock() - start
  times[#times + 1] = time
  total = total + time
end
table.sort(times)
print(string.format("%.3f %.6f", times[math.floor(#times / 2) + 1] * 1000, result))
