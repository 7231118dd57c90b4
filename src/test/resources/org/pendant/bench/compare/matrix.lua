local function product(a, b)
  local c = {
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
  }
  local i = 1
  while i <= 6 do
    local j = 1
    while j <= 6 do
      local sum = 0.0
      local k = 1
      while k <= 6 do
        sum = sum + a[i][k] * b[k][j]
        k = k + 1
      end
      c[i][j] = sum
      j = j + 1
    end
    i = i + 1
  end
  return c
end

local function example()
  return {
    { 1.5, 2.0, 3.0, 4.0, 5.0, 6.0 },
    { 2.0, 3.0, 4.0, 5.0, 6.0, 7.0 },
    { 3.0, 4.0, 5.0, 6.0, 7.0, 8.0 },
    { 4.0, 5.0, 6.0, 7.0, 8.0, 9.0 },
    { 5.0, 6.0, 7.0, 8.0, 9.0, 1.0 },
    { 6.0, 7.0, 8.0, 9.0, 1.0, 2.0 },
  }
end

return function()
  local a = example()
  local b = example()
  local trace = 0.0
  local n = 0
  while n < 1000 do
    a[1][1] = n
    local c = product(a, b)
    trace = trace + c[1][1] + c[6][6]
    n = n + 1
  end
  return trace
end
