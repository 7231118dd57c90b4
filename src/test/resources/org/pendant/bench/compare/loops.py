def weigh(values):
    total = 0.0
    i = 0
    while i < 1000000:
        j = 0
        while j < 10:
            total = total + values[j] * 0.5
            j = j + 1
        i = i + 1
    return total


def run():
    return weigh([1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10.5])
