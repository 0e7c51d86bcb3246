local a = {}
local visited, checksum = 0, 0
local function visit()
    visited = visited + 1
    checksum = (checksum * 3 + a[0] * 5 + a[8]) % 1000003
end
local function permute(k)
    if k == 1 then
        visit()
        return
    end
    permute(k - 1)
    for i = 0, k - 2 do
        local other = k % 2 == 0 and i or 0
        local spare = a[other]
        a[other] = a[k - 1]
        a[k - 1] = spare
        permute(k - 1)
    end
end
for i = 0, 8 do a[i] = i end
for k = 0, 2 do permute(9) end
print(visited, checksum)
