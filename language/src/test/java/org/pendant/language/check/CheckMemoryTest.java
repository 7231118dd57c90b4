package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

final class CheckMemoryTest {
  private static final int PROGRAMS = 30;
  private static final int EDITS = 25;

  private static final List<String> LINES =
      List.of(
          "a = 1",
          "a = \"s\"",
          "global g = 1",
          "global g = [1, 2]",
          "local a = p[0, 0, 0, 0, 0, 0]",
          "g = g + 1",
          "g = a",
          "b = a + g",
          "b = \"x\" + 1",
          "f0()",
          "f1(1)",
          "f1(1, 2)",
          "f2(x=1, y=2)",
          "f2(z=1)",
          "f3",
          "c = f1(1) + 1",
          "sleep(1)",
          "sleep()",
          "movej(a)",
          "movej([1, 2], tt=1)",
          "set_flag_old()",
          "nothing(1)",
          "textmg(1)",
          "textmsg(zzz)",
          "q = aa",
          "run t0()",
          "join a",
          "kill f0()",
          "while True:\nend",
          "while True:\nf0()\nend",
          "while True:\nf1(1)\nsync()\nend",
          "while a < 3:\nbreak\nend",
          "break",
          "return 1",
          "halt",
          "if g:\na = 2\nelse:\nb = 3\nend",
          "a.append(1)",
          "a.nothing()",
          "g[0] = 2",
          "a.b = 1",
          "digital_out[1] = True",
          "interpreter_mode()",
          "def inner(u):\nu = u + a\nend",
          "inner(2)",
          "popup(\"x\", blocking=True)",
          "struct(a=1, a=2)",
          "sqrt(\"s\")",
          "length = 1");

  private static final List<String> HEADS =
      List.of(
          "def f0():",
          "def f1(x):",
          "def f1(x, y=1):",
          "def f2(x=1, y=g):",
          "def f3(x, x):",
          "thread t0():",
          "thread f0():",
          "def textmsg(s):",
          "sec s0():",
          "def f4(g=f0()):");

  /** A program by its definitions, each of them a head and lines. */
  private static final class Program {
    private final SplittableRandom random;
    private final List<List<String>> definitions = new ArrayList<>();
    private final boolean nested;

    Program(SplittableRandom random) {
      this.random = random;
      nested = random.nextBoolean();
      for (int i = 1 + random.nextInt(5); i >= 0; i--) {
        definitions.add(definition());
      }
    }

    private List<String> definition() {
      List<String> lines = new ArrayList<>(List.of(pick(HEADS)));
      for (int i = random.nextInt(5); i > 0; i--) {
        lines.add(pick(LINES));
      }
      return lines;
    }

    private String pick(List<String> from) {
      return from.get(random.nextInt(from.size()));
    }

    void edit() {
      List<String> edited = definitions.get(random.nextInt(definitions.size()));
      switch (random.nextInt(7)) {
        case 0 -> definitions.add(random.nextInt(definitions.size() + 1), definition());
        case 1 -> edited.set(0, pick(HEADS));
        case 2 -> edited.subList(Math.max(1, edited.size() - 1), edited.size()).clear();
        case 3 -> definitions.remove(definitions.size() > 2 ? edited : List.of());
        default -> edited.add(1 + random.nextInt(edited.size()), pick(LINES));
      }
    }

    Source source() {
      String text =
          definitions.stream()
              .map(lines -> String.join("\n", lines) + "\nend\n")
              .collect(Collectors.joining());
      String main = "global g = 0\nf0()\nf1(2)\nrun t0()\n";
      return Source.of("p", nested ? "def p():\n" + text + main + "end\n" : text + main);
    }
  }

  @Test
  void aCheckThatRemembersSaysWhatOneThatDoesNotSays() {
    SmallCatalogue catalogue = new SmallCatalogue();
    int said = 0;
    int remembered = 0;
    for (int seed = 0; seed < PROGRAMS; seed++) {
      Program program = new Program(new SplittableRandom(seed));
      CheckMemory memory = new CheckMemory();
      List<Diagnostic> before = List.of();
      for (int i = 0; i < EDITS; i++) {
        Source source = program.source();
        ParseResult parsed = ScriptParser.parseProgram(source);
        if (parsed.ok()) {
          ProgramForm form = ProgramForm.of(parsed.script());
          List<Diagnostic> whole = Checker.check(form, catalogue);
          said += whole.size();
          List<Diagnostic> now = Checker.check(source, form, Scopes.of(form), catalogue, memory);
          assertEquals(whole, now, "seed " + seed + " edit " + i + "\n" + source.text());
          List<Diagnostic> last = before;
          remembered += (int) now.stream().filter(each -> isOf(last, each)).count();
          before = now;
        }
        program.edit();
      }
    }
    assertTrue(said > 1000, said + " diagnostics");
    assertTrue(remembered > 500, remembered + " of " + said + " remembered");
  }

  /** Whether it has the very text of one of them, and not one that was written again. */
  private static boolean isOf(List<Diagnostic> said, Diagnostic one) {
    IdentityHashMap<String, Boolean> texts = new IdentityHashMap<>();
    said.forEach(each -> texts.put(each.message(), true));
    return texts.containsKey(one.message());
  }

  @Test
  void whatIsSaidOfADefinitionThatIsTheSameIsSaidAgain() {
    String text =
        """
        def a():
          x = 1
        end
        def b():
          movej(1, v="s")
          while True:
          end
        end
        b()
        c = 1
        """;
    SmallCatalogue catalogue = new SmallCatalogue();
    CheckMemory memory = new CheckMemory();
    List<Diagnostic> before = check(text, catalogue, memory);
    List<Diagnostic> moved = check(text.replace("x = 1", "x = 100"), catalogue, memory);
    assertEquals(List.of("type-mismatch", "type-mismatch"), codes(before).subList(0, 2));
    assertSame(before.getFirst().message(), moved.getFirst().message());
    assertEquals(before.getFirst().range().start() + 2, moved.getFirst().range().start());
    List<Diagnostic> otherwise = check("global m = 1\n" + text, catalogue, memory);
    assertNotSame(before.getFirst().message(), otherwise.getFirst().message());
  }

  private static List<Diagnostic> check(String text, SmallCatalogue catalogue, CheckMemory memory) {
    Source source = Source.of("s", text);
    ProgramForm form = ProgramForm.of(ScriptParser.parseProgram(source).script());
    return Checker.check(source, form, Scopes.of(form), catalogue, memory);
  }

  private static List<String> codes(List<Diagnostic> found) {
    return found.stream().map(Diagnostic::code).toList();
  }
}
