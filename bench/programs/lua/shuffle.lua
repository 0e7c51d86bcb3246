local state = 42
local function next(n)
    state = (state * 1103515245 + 12345) % 2147483648
    return state // 16 % n
end
local n = 100000
local deck = {}
for i = 0, n - 1 do deck[i] = i end
for round = 0, 4 do
    for i = n - 1, 1, -1 do
        local j = next(i + 1)
        local spare = deck[i]
        deck[i] = deck[j]
        deck[j] = spare
    end
end
local function quicksort(a, from, to)
    local lows, highs, size = {[0] = from}, {[0] = to}, 1
    while size > 0 do
        size = size - 1
        local lo = lows[size]
        local hi = highs[size]
        if lo < hi then
            local pivot = a[(lo + hi) // 2]
            local i = lo
            local j = hi
            while i <= j do
                while a[i] < pivot do i = i + 1 end
                while a[j] > pivot do j = j - 1 end
                if i <= j then
                    local spare = a[i]
                    a[i] = a[j]
                    a[j] = spare
                    i = i + 1
                    j = j - 1
                end
            end
            lows[size] = lo
            highs[size] = j
            size = size + 1
            lows[size] = i
            highs[size] = hi
            size = size + 1
        end
    end
    return a
end
local check = 0
for i = 0, n - 1, 1000 do check = (check * 7 + deck[i]) % 1000003 end
local sorted = quicksort(deck, 0, n - 1)
local good = true
for i = 0, n - 1 do if sorted[i] ~= i then good = false end end
print(check, good)
