package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ScriptFailure;

/** The values of a program have a limit together; what it has dropped does not count. */
class ProgramMemoryTest {
  private static final long LIMIT_BYTES = 20_000_000;

  private final RunningProgram program =
      new RunningProgram(ControllerOptions.headless().withMemory(LIMIT_BYTES));

  private ScriptFailure failed(String text) {
    program.start(text);
    program.finish();
    Ending ending = program.state().program().ending().orElseThrow();
    return assertInstanceOf(Ending.Failed.class, ending, ending::toString).failure();
  }

  @Test
  void programThatTakesMoreFailsWhereItDoes() {
    ScriptFailure failure =
        failed(
            """
            def prog():
              def more():
                return make_list(1000000, 0, 1000000)
              end
              a = more()
              b = more()
              c = more()
            end
            """);
    assertEquals("out-of-memory", failure.code());
    assertEquals(3, failure.line());
    assertTrue(failure.message().contains("may take at most 20 MB"), failure.message());
    assertEquals(List.of(), program.said());
  }

  @Test
  void controllerRunsOtherProgramsAfterIt() {
    failed("def prog():\n  a = make_list(1000000, \"x\", 1000000)\nend\n");
    program.start("def other():\n  textmsg(length(make_list(1000000, 0, 1000000)))\nend\n");
    program.finish();
    assertEquals(List.of("1000000"), program.said());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        // globals and their parts
        "s = struct(l=make_list(900000, 0, 1000000), t=make_list(0, 0, 1000000))\nu = s\nv = s",
        // many strings
        """
        l = make_list(10000, "", 10000)
        i = 0
        while i < 10000:
          l[i] = str_cat("a long text of many bytes, of which there are a thousand", i)
          l[i] = l[i] + l[i] + l[i] + l[i] + l[i] + l[i] + l[i] + l[i] + l[i] + l[i]
          l[i] = l[i] + l[i] + l[i] + l[i]
          i = i + 1
        end
        """,
        // the stacks of threads
        "thread t():\n  local l = make_list(500000, 0, 500000)\n  sleep(100)\nend\n"
            + "run t()\nrun t()\nrun t()\nrun t()\nrun t()\nrun t()\nsleep(1)",
        // the stack of one
        "def f(n):\n  local l = make_list(10000, 0, 10000)\n  if n > 0:\n    return f(n - 1)\n"
            + "  end\n  return 0\nend\nx = f(900)",
        // what is under way
        "a = make_list(700000, 1, 700000)\nthread t():\n  b = a + a\nend\n"
            + "run t()\nrun t()\nrun t()\nsync()\nsync()\nsync()\nsync()\nsync()"
      })
  void everythingCounts(String statements) {
    assertEquals("out-of-memory", failed("def prog():\n" + statements.indent(2) + "end\n").code());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "i = 0\nwhile i < 60:\n  a = make_list(1000000, 0, 1000000)\n  i = i + 1\nend",
        "i = 0\ns = \"x\"\nwhile i < 2000:\n  s = s + \"yyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyy\"\n"
            + "  i = i + 1\nend",
        "def f(l):\n  l[0] = 1\n  return l\nend\na = make_list(100000, 0, 100000)\ni = 0\n"
            + "while i < 300:\n  b = f(a)\n  i = i + 1\nend",
        "thread t():\n  local l = make_list(500000, 0, 500000)\nend\ni = 0\n"
            + "while i < 40:\n  h = run t()\n  join h\n  i = i + 1\nend",
        "def f(n):\n  local l = make_list(10000, 0, 10000)\n  if n > 0:\n    return f(n - 1)\n"
            + "  end\n  return 0\nend\nx = f(180)\na = make_list(900000, 0, 900000)"
      })
  void whatIsDroppedDoesNotCount(String statements) {
    program.start("def prog():\n" + statements.indent(2) + "  textmsg(\"done\")\nend\n");
    program.finish();
    assertEquals(List.of("done"), program.said(), () -> program.reported().toString());
  }

  @Test
  void secondaryProgramsHaveTheLimitToo() {
    program.ask(
        new ProgramCommand.RunSecondary(
            program.program("sec s():\n  a = make_list(1000000, \"x\", 1000000)\nend\n")));
    program.advance(2);
    assertTrue(
        program.reported().toString().contains("out of memory"), program.reported()::toString);
  }
}
