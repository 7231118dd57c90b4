package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Operations on large values take several frames, in which other threads continue. */
class LongOperationProgramTest {
  /** Changes whatever the main thread works on, in every frame, until it is killed. */
  private static String whileChanged(String change, String statements) {
    return """
    def prog():
      a = make_list(1000000, 1, 1000000)
      c = make_list(1000000, 1, 1000000)
      s = struct(l=a, n=1)
      t = struct(l=a, n=1)
      m = [[1, 0], [0, 1]]
      turns = 0
      thread changer():
        while True:
          turns = turns + 1
          %s
          sync()
        end
      end
      %s
    end
    """
        .formatted(change, statements.indent(2).strip());
  }

  private static List<String> said(String text) {
    RunningProgram program = new RunningProgram();
    program.start(text);
    program.finish();
    assertEquals(List.of(), program.reported());
    return program.said();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "a[999999] = turns",
        "a.remove(0)",
        "a.clear()",
        "a = [2]",
        "c[999998] = 5",
        "a.pop()"
      })
  void comparedListsAreThoseThatWereThereAtFirst(String change) {
    String text =
        whileChanged(
            change,
            """
            h = run changer()
            equal = a == c
            kill h
            textmsg(equal, turns > 0)
            """);
    assertEquals(List.of("TrueTrue"), said(text));
  }

  @Test
  void comparedStructsAreThoseThatWereThereAtFirst() {
    String text =
        whileChanged(
            "s.l[999999] = 7",
            """
            h = run changer()
            different = s != t
            kill h
            textmsg(different, turns > 0)
            """);
    assertEquals(List.of("FalseTrue"), said(text));
  }

  @Test
  void addedListsAreThoseThatWereThereAtFirst() {
    String text =
        whileChanged(
            "a[999999] = 1000",
            """
            h = run changer()
            b = a + c
            kill h
            textmsg(b[0], b[999999])
            textmsg(turns > 0, a[999999])
            """);
    assertEquals(List.of("22", "True1000"), said(text));
  }

  @Test
  void otherThreadsGoOnMeanwhile() {
    String text =
        whileChanged(
            "",
            """
            h = run changer()
            i = 0
            while i < 20:
              b = a + c
              i = i + 1
            end
            kill h
            textmsg(turns > 40)
            """);
    assertEquals(List.of("True"), said(text));
  }

  @Test
  void operationOfThreadThatIsKilledLeavesItsVariableAlone() {
    String text =
        """
        def prog():
          a = make_list(1000000, 1, 1000000)
          b = a
          thread adder():
            b = a + a
            textmsg("over")
          end
          h = run adder()
          sync()
          sync()
          kill h
          sleep(0.2)
          textmsg(b[0], b[999999])
        end
        """;
    assertEquals(List.of("11"), said(text));
  }

  @Test
  void operationOfAThreadStopsWithItsProgram() {
    RunningProgram program = new RunningProgram();
    program.start(
        """
        def prog():
          a = make_list(1000000, 1, 1000000)
          while True:
            b = a + a
          end
        end
        """);
    program.advance(100);
    program.done(new ProgramCommand.StopProgram());
    program.start("def other():\n  textmsg(1 + 1)\nend\n");
    program.finish();
    assertEquals(List.of("2"), program.said());
    assertTrue(program.reported().isEmpty());
  }

  @Test
  void partThatIsChangedByMethodIsNotSharedMeanwhile() {
    // the other thread copies the whole again and again, wherever the change may have got to
    String text =
        """
        def prog():
          s = struct(l=make_list(900000, 1, 1000000), n=1)
          copies = 0
          thread copier():
            while copies < 30:
              t = s
              first = t.l.length()
              copies = copies + 1
              sync()
              if t.l.length() != first:
                textmsg("the copy has changed")
              end
            end
          end
          h = run copier()
          while copies < 30:
            s.l.append(2)
          end
          join h
          textmsg("done")
        end
        """;
    assertEquals(List.of("done"), said(text));
  }
}
