local column, taken, up, down = {}, {}, {}, {}
for i = 0, 9 do column[i] = 0 taken[i] = false end
for i = 0, 19 do up[i] = false down[i] = false end
local found = 0
local n = 8
local function place(row)
    if row == n then
        found = found + 1
        return
    end
    for c = 0, n - 1 do
        if not taken[c] and not up[row + c] and not down[row - c + n] then
            taken[c] = true
            up[row + c] = true
            down[row - c + n] = true
            column[row] = c
            place(row + 1)
            taken[c] = false
            up[row + c] = false
            down[row - c + n] = false
        end
    end
end
for k = 0, 59 do place(0) end
n = 9
for k = 0, 29 do place(0) end
print(found)
