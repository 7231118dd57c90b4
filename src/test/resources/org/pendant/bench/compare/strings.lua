return function()
  local bytes = 0
  local i = 0
  while i < 200 do
    local line = ""
    local j = 0
    while j < 200 do
      line = line .. tostring(i * j) .. ","
      j = j + 1
    end
    bytes = bytes + #line
    i = i + 1
  end
  return bytes
end
