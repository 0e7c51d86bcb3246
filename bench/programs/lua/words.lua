local text = "the quick brown fox jumps over the lazy dog and the cat sat on the mat while it rained all day long in the old town"
local count = {}
local n = 0
for k = 1, 75000 do for w in text:gmatch("[^ ]+") do if not count[w] then n = n + 1 end count[w] = (count[w] or 0) + 1 end end
print(count["the"], n)
