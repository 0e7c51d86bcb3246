local function steps(start)
    local n = start
    local count = 0
    while n ~= 1 do
        if n % 2 == 0 then
            n = n // 2
        else
            n = 3 * n + 1
        end
        count = count + 1
    end
    return count
end
local function gcd(a, b)
    local x = a
    local y = b
    while y ~= 0 do
        local rest = x % y
        x = y
        y = rest
    end
    return x
end
local longest, best = 0, 0
for i = 1, 59999 do
    local s = steps(i)
    if s > longest then
        longest = s
        best = i
    end
end
local coprime = 0
for a = 1, 499 do
    for b = 1, 499 do
        if gcd(a, b) == 1 then coprime = coprime + 1 end
    end
end
print(best, longest, coprime)
