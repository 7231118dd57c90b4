package org.pendant.script.vm;

import static org.pendant.script.vm.TranslatedScripts.FIBONACCI;

import java.util.List;

/** Functions that call each other with plain values, which other code calls again and again. */
final class TranslatedCalls {
  private TranslatedCalls() {}

  static List<String> calls() {
    return List.of(
        FIBONACCI,
        """
        def kinds_change():
          def f(n, x):
            if n <= 0:
              return x
            end
            local half = x / 2
            local y = f(n - 1, half) + f(n - 2, x * n)
            if n % 3 == 0:
              y = y + 1
            end
            return y - half
          end
          local i = 0
          while i < 12:
            textmsg(f(i, i), f(i, i + 0.5))
            i = i + 1
          end
          textmsg(f(4, True))
        end
        """,
        """
        def overflow_inside():
          def product(n):
            if n < 2:
              return 1
            end
            return product(n - 1) * n
          end
          local i = 0
          while True:
            textmsg(product(i))
            i = i + 1
          end
        end
        """,
        """
        def division_inside():
          def g(n):
            return 12 / n + 7 % n
          end
          def f(n):
            local sum = 0
            local k = 5
            while k >= n:
              sum = sum + g(k)
              k = k - 1
            end
            return sum
          end
          local i = 3
          while True:
            textmsg(f(i), -f(i))
            i = i - 1
          end
        end
        """,
        """
        def not_a_number():
          def big(n):
            if n == 0:
              return 1.5
            end
            local b = big(n - 1) * 1000.0
            return b * b
          end
          def f(n):
            local x = big(n)
            local y = x - x
            return y
          end
          local i = 0
          while i < 12:
            textmsg(f(i), f(i) == f(i))
            textmsg(f(i) < 1, not f(i))
            i = i + 1
          end
        end
        """,
        """
        def now_and_then():
          def none(n):
            if n % 2 == 0:
              return n
            end
          end
          def odd(n):
            if n == 0:
              return False
            end
            return even(n - 1)
          end
          def even(n):
            if n == 0:
              return True
            end
            return odd(n - 1)
          end
          def mixed(n):
            if n % 3 == 0:
              return n
            elif n % 3 == 1:
              return n * 0.5
            end
            local b = odd(n)
            if b:
              return -n
            end
            return even(n)
          end
          local i = 0
          while i < 40:
            textmsg(none(i), odd(i))
            textmsg(mixed(i), even(i) == odd(i))
            i = i + 1
          end
          while True:
            textmsg(mixed(i) + 1)
            i = i + 1
          end
        end
        """,
        """
        def left_out():
          def f(a, b=a * 2, c=7):
            if a > 5:
              local x = a - b
            end
            while a > c:
              a = a - 1
              local y = a + b
            end
            if a == 6:
              return x + y
            end
            return b + c
          end
          local i = 0
          while True:
            textmsg(f(i), f(i, 3.5))
            textmsg(f(i, c=2.5), f(a=i, c=i))
            i = i + 1
          end
        end
        """,
        """
        def of_either_type():
          def power(n):
            local s = 1
            if n % 2 == 0:
              s = 0.5
            end
            local k = 0
            while k < n:
              s = s * -7
              k = k + 1
            end
            return -s + 2
          end
          local i = 0
          while True:
            textmsg(power(i), power(i + 1) < power(i))
            i = i + 1
          end
        end
        """,
        """
        def deep_and_back():
          def down(n, x):
            if n <= 0:
              return x
            end
            return down(n - 1, x + 0.25) - 1
          end
          local i = 1
          while True:
            textmsg(down(i, 0), down(i, 0.5))
            i = i * 2
          end
        end
        """,
        """
        def outside():
          global calls = 0
          def leaf(n):
            calls = calls + 1
            return n * 2
          end
          def tell(n):
            if n == 3:
              textmsg("three", calls)
            end
            if n == 5:
              sync()
            end
            return leaf(n)
          end
          def sum(n):
            local s = 0
            local k = 0
            while k < n:
              s = s + tell(k) + leaf(k)
              k = k + 1
            end
            return s
          end
          local i = 0
          while i < 9:
            textmsg(sum(i), calls)
            i = i + 1
          end
        end
        """,
        """
        def two_threads():
          global a = 0
          global b = 0
          def fib(n):
            if n < 2:
              return n
            end
            return fib(n - 1) + fib(n - 2)
          end
          thread one():
            local i = 0
            while i < 9:
              a = a + fib(i)
              i = i + 1
            end
          end
          thread two():
            local i = 0
            while i < 9:
              b = b + fib(i) * 0.5
              i = i + 1
            end
          end
          local h = run one()
          local k = run two()
          join h
          join k
          textmsg(a, b)
        end
        """);
  }
}
