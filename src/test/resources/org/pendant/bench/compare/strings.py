def run():
    count = 0
    i = 0
    while i < 200:
        line = ""
        j = 0
        while j < 200:
            line = line + str(i * j) + ","
            j = j + 1
        count = count + len(line)
        i = i + 1
    return count
