local function weigh(values)
  local sum = 0.0
  local i = 0
  while i < 1000000 do
    local j = 1
    while j <= 10 do
      sum = sum + values[j] * 0.5
      j = j + 1
    end
    i = i + 1
  end
  return sum
end

return function()
  return weigh({ 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10.5 })
end
