package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Programs written the way real ones are: nothing in them may be complained about. */
final class RealisticProgramsTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        // A generated program: labels, a watching thread, assignments always marked global.
        """
        def cell():
          step_count = 0.0
          thread Step_Counter():
            while (True):
              step_count = step_count + 1.0
              sync()
            end
          end
          run Step_Counter()
          global home=[0.0, -1.57, 1.57, -1.57, -1.57, 0.0]
          global part=p[.4, -.2, 0.1, 0, 3.14, 0]
          def approach(target, above=0.1):
            local lifted = pose_trans(target, p[0, 0, -above, 0, 0, 0])
            movej(lifted, a=1.4, v=1.05)
            return lifted
          end
          while (True):
            $ 1 "Robot Program"
            $ 2 "Loop 3 times" "noBreak"
            global Loop_1 = 0
            while (Loop_1 < 3):
              global last = approach(part)
              if (last[2] > 0.3 or get_digital_in(3) == True):
                break
              else:
              end
              Loop_1 = Loop_1 + 1
            end
            movej(home)
          end
        end
        """,
        // A driver: handles in number variables, conditions that are numbers, late globals.
        """
        def driver():
          thread_move = 0
          has_qnear = 0
          thread mover():
            while not stopped:
              enter_critical
              target = wanted
              exit_critical
              movej(target, t = 0.1)
            end
            sync()
            return False
          end
          def stop():
            if thread_move != 0:
              kill thread_move
              thread_move = 0
            end
          end
          stopped = False
          wanted = get_actual_joint_positions()
          target = wanted
          thread_move = run mover()
          if has_qnear:
            join thread_move
          end
          stop()
        end
        """,
        // Lists, matrices and structs.
        """
        def numbers():
          local gain = [[1, 0], [0, 2]]
          v = gain * [1, 2] + 3
          w = v * v / 10 - [1, 1]
          m = 2 * gain % 5
          b = gain[0,1]
          l = make_list(0, 0, 10)
          while l.length() < l.capacity():
            l.append(l.length())
          end
          s = struct(position = p[0,0,0,0,0,0], name = "a", values = [1, 2.5])
          s.values[0] = 22.5
          s.name = "b"
          i = 0
          while i < s.length():
            textmsg("member ", s[i])
            i = i + 1
          end
          sums = [0.0, 0.0]
          sums = sums + struct(a = 1.0, b = 2.0)
          if l != [252, 82] and norm(v) < 1e-6 and not s.name == "c":
            textmsg(str_cat("n = ", to_str(floor(b / 2))))
          end
        end
        """,
        // A fragment as add-ons ship it, with names that are functions too.
        """
        global grip_open = False
        def grip(length, time=1.0):
          if (grip_open):
            local length = length + 1
            sleep(time)
          end
          grip_open = not grip_open
          return length
        end
        thread watch():
          while (True):
            if get_digital_in(0): halt end
            sync()
          end
        end
        run watch()
        opened = grip(length=2)
        textmsg("opened ", opened)
        """,
        // Parsing text, recursion, early returns, values of several kinds by path.
        """
        def fib(n):
          if n < 2:
            return n
          end
          return fib(n - 1) + fib(n - 2)
        end
        def answer(kind):
          if kind == 0:
            result = "none"
            return result
          elif kind == 1:
            result = 1
            return result
          end
          return None
        end
        def prog():
          text = "a" + "b"
          value = answer(1)
          value = answer(1) + fib(10)
          first = True
          while True:
            if not first and previous > 2:
              break
            end
            previous = value
            first = False
          end
          textmsg(text + to_str(previous), -value)
        end
        """
      })
  void nothingIsFound(String program) {
    assertEquals(List.of(), Checks.found(program));
  }
}
