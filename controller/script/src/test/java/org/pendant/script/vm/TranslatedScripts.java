package org.pendant.script.vm;

import java.util.List;

/** Programs that must do the same in every form. */
final class TranslatedScripts {
  static final String FIBONACCI =
      """
      def prog():
        def fib(n):
          if n < 2:
            return n
          end
          return fib(n - 1) + fib(n - 2)
        end
        textmsg(fib(24))
      end
      """;

  private TranslatedScripts() {}

  static List<String> scripts() {
    return List.of(
        FIBONACCI,
        """
        def arithmetic():
          local i = 7
          local f = 2.5
          textmsg(i + 2, i - 9)
          textmsg(i * f, i / 2)
          textmsg(i % 4, -i)
          textmsg(-f, -(i - 7))
          textmsg(0 * -1, 0.0 * -1)
          textmsg(-7 % 3, 7.5 % 2)
          textmsg(i == 7.0, i != 7)
          textmsg(i < f, i <= 7)
          textmsg(i > f, not (i >= 8))
          textmsg(True == 1, False == "x")
          textmsg(True xor i < f, None == None)
          local b = i > 3 and f < 3 or i == 0
          textmsg(b, not b)
          local s = "a"
          s = s + "b"
          textmsg(s + "c", s == "ab")
          local n = f
          n = 3
          textmsg(n, [i, f])
          global g = 1
          while g < 1000:
            g = g * 3
            g = g - 1
          end
          textmsg(g)
        end
        """,
        """
        def overflow():
          local i = 1
          while i > 0:
            i = i * 5 + 1
            textmsg(i)
          end
        end
        """,
        """
        def division(): local x = 0
          while x < 3:
            textmsg(6 / (2 - x))
            x = x + 1
          end
        end
        """,
        """
        def kinds():
          def f(y):
            local x = 1
            textmsg(x + 1)
            x = y
            return x
          end
          textmsg(f(1.5))
          textmsg(f(True))
        end
        """,
        """
        def ordered():
          local l = [1, 2, 3]
          def f(a, b):
            return a < b
          end
          textmsg(f(1, 2), f(2.5, 2))
          textmsg(f(1, l))
        end
        """,
        """
        def condition():
          def f(a):
            if a:
              return 1
            end
          end
          textmsg(f(True), f(0))
          textmsg(f("x"), f(""))
          textmsg(f([1]))
        end
        """,
        """
        def missing():
          def f(a, b):
            return a
          end
          def g(n):
            if n == 3:
              return f(n)
            end
            return f(n, 0)
          end
          local i = 0
          while True:
            textmsg(g(i))
            i = i + 1
          end
        end
        """,
        """
        def defaults():
          global calls = 0
          def next(n=calls):
            calls = n + 1
            return calls
          end
          def f(a=next(), b=a * 2, c=[a, b]):
            c[0] = b
            return a + c[0] + c[1]
          end
          local i = 0
          while i < 20000:
            i = i + f(1)
            i = i + f(b=next())
          end
          textmsg(i, calls)
          textmsg(f("x"))
        end
        """,
        """
        def texts():
          def f(x):
            return not x
          end
          local s = ""
          local i = 0
          local counted = 0
          while i < 20 and (i < 10 or s):
            if not s:
              s = "a"
            elif s and "" or not (s xor ""):
              counted = -1
            end
            if s:
              counted = counted + 1
              s = ""
            end
            local kept = not s
            i = i + 1
          end
          textmsg(counted, kept)
          textmsg(not f([1]))
        end
        """,
        """
        def unassigned():
          def f(a):
            if a > 1:
              local x = a
            end
            return x + 1
          end
          textmsg(f(2))
          textmsg(f(1))
        end
        """,
        """
        def elements():
          def fill(m, rows, columns, x):
            local r = 0
            while r < rows:
              local c = 0
              while c < columns:
                m[r, c] = m[r, c] + x * c
                c = c + 1
              end
              r = r + 1
            end
            return m
          end
          local small = [[1, 2], [3, 4]]
          textmsg(fill(small, 2, 2, 3), small)
          textmsg(fill(small, 2, 2, 0.5), fill([[1.5, 2], [3, 4]], 2, 2, 1))
          local row = [1, 2, 3, 4, 5, 6, 7]
          local large = [row, row, row, row, row, row, row]
          local same = large
          large[6, 6] = 8
          textmsg(fill(large, 7, 7, 1), same)
          textmsg(fill(large, 7, 8, 1))
        end
        """,
        """
        def element_of_another_kind():
          local m = [[1, 2], [3, 4]]
          local i = 0
          while True:
            m[i, 1] = 5.5
            m[1, i] = i > 0
            i = i + 1
          end
        end
        """,
        """
        def components():
          local p = p[1, 2, 3, 0.1, 0.2, 0.3]
          local q = p
          local x = 1
          local i = 0
          while i < 6:
            q[i] = p[i] * 2
            q[5 - i] = i
            x = q[i]
            i = i + 1
          end
          textmsg(p, q)
          textmsg(x, p[2.0])
          q[2] = True
        end
        """,
        """
        def components_into_another_type():
          def keep(flag, p):
            flag = p[5]
            return flag
          end
          local p = p[1, 2, 3, 0.1, 0.2, 0.3]
          textmsg(keep(1, p), keep(2.5, p))
          textmsg(keep(False, p))
        end
        """,
        """
        def components_outside():
          local p = p[1, 2, 3, 0.1, 0.2, 0.3]
          local i = 4
          while True:
            p[i] = p[i] + 1
            i = i + 1
          end
        end
        """,
        """
        def lists():
          local l = [1, 2, 3]
          local m = [1.5, 2.5]
          local i = 0
          while i < 3:
            l[i] = l[i] * 2
            i = i + 1
          end
          local k = l
          k[0] = 9.5
          m[1] = l[2]
          l[1] = m[0]
          textmsg(l, k)
          textmsg(m)
          local a = [[1, 2], [3, 4]]
          a[1, 0] = 7
          textmsg(a * a, a[0])
          local t = ["a", "b"]
          t[1] = t[0] + "c"
          textmsg(t, t[1])
          local p = p[1, 2, 3, 0, 0, 0]
          p[2] = p[0] * 4
          textmsg(p)
          local s = struct(a = 1, b = [2, 3])
          s.a = s.b[1]
          s.b[0] = 8
          textmsg(s)
          textmsg(l[i])
        end
        """,
        """
        def elements():
          def trace(m, n):
            local sum = 0
            local i = 0
            while i < n:
              sum = sum + m[i, i] * m[i, 1]
              i = i + 1
            end
            return sum
          end
          local ints = [[1, 2], [3, 4]]
          local floats = [[1.5, 2.5], [3.5, 4.5]]
          ints[0, 1] = 7
          textmsg(trace(ints, 2), trace(floats, 2))
          floats[1, 1] = ints[0, 1]
          textmsg(floats, [1, 2][trace([[1, 1], [0, 0]], 2)])
          textmsg(trace(ints, 3))
        end
        """,
        """
        def wrong_element():
          local l = [1, 2]
          l[0] = 3
          l[1] = True
        end
        """,
        """
        def float_index():
          local l = [1, 2, 3]
          textmsg(l[1.0])
          textmsg(l[0.5])
        end
        """,
        """
        def threads():
          global n = 0
          thread counter():
            local i = 0
            while True:
              n = n + 1
              i = i + 1
              if i % 3 == 0:
                sync()
              end
            end
          end
          thread once():
            n = n + 100
            return 5
          end
          local a = run counter()
          local b = run once()
          join b
          sync()
          sync()
          kill a
          textmsg(n, a)
          enter_critical
          n = 0
          while n < 120000:
            n = n + 1
          end
          exit_critical
          textmsg(n)
          join a
        end
        """,
        """
        def crowd():
          global turns = 0
          thread worker():
            local i = 0
            while i < 30000:
              i = i + 1
              turns = turns + i % 7
            end
          end
          local i = 0
          while i < 12:
            local h = run worker()
            i = i + 1
          end
          join h
          textmsg(turns)
        end
        """,
        """
        def suicide():
          thread t():
            sync()
            kill 1
            textmsg("never")
          end
          local h = run t()
          sync()
          sync()
          sync()
          textmsg("alive")
        end
        """,
        """
        def too_deep():
          def down(n):
            return down(n + 1) + 1
          end
          textmsg(down(0))
        end
        """,
        """
        def deep():
          def down(n):
            if n == 0:
              sync()
              return 0
            end
            local x = [n, 1.5]
            return down(n - 1) + x[1]
          end
          local i = 0
          while i < 3:
            textmsg(down(900))
            textmsg(down(100 + 20 * i))
            i = i + 1
          end
        end
        """,
        """
        def failing_inside():
          def inner(l, i):
            return l[i] + 1
          end
          def outer(n):
            local s = 0

            while True:
              s = s + inner([1, 2, 3], n)
              n = n + 1
            end
          end
          textmsg(outer(0))
        end
        """,
        """
        def nested_loops():
          local s = 0.5
          local i = 0
          while i < 700:
            local j = 0
            while j <= 700:
              if j == 350:
                j = j + 2
                continue
              end
              s = s + i * j
              j = j + 1
              if j > 690:
                break
              end
            end
            i = i + 1
          end
          textmsg(s)
        end
        """,
        """
        def calls_exhaust():
          def nothing(x, y=[1, 2]):
            return y
          end
          local i = 0
          while i < 90000:
            nothing(i)
            i = i + 1
          end
          textmsg(i, nothing(1))
        end
        """,
        """
        def halting():
          local i = 0
          while True:
            i = i + 1
            if i == 70000:
              textmsg(i)
              halt
            end
          end
        end
        """,
        """
        def pausing():
          textmsg("before")
          pause
          textmsg("after")
        end
        """,
        """
        def interpreting():
          global g = 1
          local x = 2.5
          local y = [1, 2]
          def twice(a):
            return 2 * a
          end
          textmsg("in")
          interpreter_mode()
          textmsg(g, x)
          textmsg(y)
          x = x + 1
          textmsg(x)
        end
        """);
  }
}
