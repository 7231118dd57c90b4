package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Statement;

class ParseStatementTest {

  @Test
  void readsEveryKindOfStatement() {
    assertShape(
        "{(set FREE a 1) (set GLOBAL b 2) (set LOCAL c 3) (set FREE <l>[0] 4) (set FREE <s>.m 5)"
            + " (do f()) (do <x>.g()) (do (run t())) (join h) (kill h) enter exit halt pause}",
        """
        a = 1
        global b = 2
        local c = 3
        l[0] = 4
        s.m = 5
        f()
        x.g()
        run t()
        join h
        kill h
        enter_critical
        exit_critical
        halt
        pause
        """);
  }

  @Test
  void readsBlocks() {
    assertShape(
        "{(if a{(do f())} elif b{} elif c{(do g())} else {(do h())})"
            + " (while x{break continue}) (if a{}) (if a{} else {})}",
        """
        if a:
          f()
        elif (b):
        elif c :
          g()
        else : # otherwise
          h()
        end # done
        while(x):
          break
          continue
        end
        if a:
        end
        if a:
        else:
        end
        """);
  }

  @Test
  void readsDefinitions() {
    assertShape(
        "{(FUNCTION f[]{}) (FUNCTION g[a b=1 c=(- 2.0)]{(FUNCTION inner[]{}) (THREAD t[]{(return"
            + " False)}) (return (a + b))}) (SECONDARY s[]{(do h())})}",
        """
        def f():
        end
        def g(a, b=1, c = -2.0) :
          def inner():
          end
          thread t():
            return False
          end
          return a+b
        end
        sec s() :
          h()
        end
        """);
  }

  @Test
  void needsNoSeparatorBetweenStatements() {
    assertShape(
        "{(set FREE hello \"x\") (set FREE l [1, 2]) (FUNCTION f[]{(set FREE a 1) (set FREE b 2)})"
            + " (if e{halt}) (while True{(do sync())}) (join t) (kill t)}",
        "hello = \"x\" l = [1,2] def f(): a = 1 b = 2 end if e: halt end while True: sync() end"
            + " join t kill t");
  }

  @Test
  void lineEndsAreBlanksInBracketsAndBehindOperators() {
    assertShape(
        "{(return ((a == b) and (c == d))) (set GLOBAL x (- 5)) (set FREE y 2)"
            + " (do f(1, v=[2, (- 3)])) (set FREE z (((a + b) and c) or d))}",
        """
        return (a == b) and
            (c == d)
        global x = # value on the next line
          -5 y = 2
        f(
          1
          ,
          v=[2,
          -3]
        )
        z = a +
          b
          and c
          or d
        """);
  }

  @Test
  void lineBeginsNewStatementWhereItWouldBeAmbiguous() {
    for (String start : List.of("(b)", "[b]", "-b", "+b")) {
      ParseResult result = ScriptParser.parseProgram(Source.of("t", "x = a\n" + start + "\ny = 1"));
      assertEquals(1, result.diagnostics().size(), start);
      assertEquals("{(set FREE x a) (set FREE y 1)}", TreeShape.of(result.script()), start);
    }
  }

  @Test
  void bareReturnEndsWithItsLine() {
    assertShape(
        "{(FUNCTION f[]{(if a{(return)}) (return) (do g())}) (FUNCTION h[]{(return None)})}",
        """
        def f():
          if a: return end
          return # nothing
          g()
        end
        def h():
          return None
        end
        """);
  }

  @Test
  void readsLabels() {
    assertShape(
        "{(label 1 Robot Program) (label 2 var_1= \"x\") (label - lost) (label 4 bare)"
            + " (set FREE x f(1, 2))}",
        """
        $ 1 "Robot Program" "noBreak"
          $ 2 "var_1= "x"" "breakAfter" "noBreak"
        $ "lost"
        $ 4 bare
        x = f(1,
          $ 5 "inside brackets"
          2)
        """);
  }

  @Test
  void acceptsWindowsLineEndsTabsAndByteOrderMark() {
    assertShape(
        "{(FUNCTION f[]{(set FREE a 1) (return a)})}",
        "\uFEFFdef f():\r\n\ta = 1 # caf\u00E9\r\n\treturn a\r\nend\r\n");
  }

  @Test
  void keepsReservedWordsUsableBehindDots() {
    assertShape(
        "{(do <rpc>.halt()) (set FREE s <time()>.sec) (set FREE x <<a>.end>.if)}",
        "rpc.halt()\ns = time().sec\nx = a.end.if\n");
  }

  @Test
  void callsFunctionWhoseNameIsAVariableToo() {
    assertShape(
        "{(set FREE time 0) (set FREE t time()) (set LOCAL length length(x))}",
        "time = 0 t = time() local length = length(x)");
  }

  @Test
  void givesExactRangesOfStatements() {
    Source source =
        Source.of(
            "s",
            """
            def f ( a, b = 1 ) : # head
              if a : g() elif b:
              end
              global x = (1)
            end
            # after
            """);
    ParseResult result = ScriptParser.parseProgram(source);
    Statement.Definition definition =
        (Statement.Definition) result.script().statements().getFirst();
    assertEquals("def f ( a, b = 1 ) :", source.text(definition.headRange()));
    assertEquals("f", source.text(definition.nameRange()));
    assertEquals("b = 1", source.text(definition.parameters().get(1).range()));
    assertEquals(
        source.text().substring(0, source.text().indexOf("# after") - 1),
        source.text(definition.range()));
    Statement.If choice = (Statement.If) definition.body().getFirst();
    assertEquals("if a : g()", source.text(choice.branches().get(0).range()));
    assertEquals("elif b:", source.text(choice.branches().get(1).range()));
    assertEquals("global x = (1)", source.text(definition.body().get(1).range()));
    assertEquals(source.text().length(), result.script().range().end());
  }

  @Test
  void readsLabelRangesWithoutLineEnd() {
    Source source = Source.of("s", "  $ 3 \"x\"\r\n");
    Statement.Label label =
        (Statement.Label) ScriptParser.parseProgram(source).script().statements().getFirst();
    assertEquals("$ 3 \"x\"", source.text(label.range()));
    assertEquals(Optional.of(3), label.number());
  }

  @Test
  void readsSingleInterpreterLine() {
    ParseResult result =
        ScriptParser.parseLine(
            Source.of("line", "def myFun(): mystring = \"Hi\" textmsg(mystring) end"));
    assertTrue(result.ok());
    assertEquals(
        "{(FUNCTION myFun[]{(set FREE mystring \"Hi\") (do textmsg(mystring))})}",
        TreeShape.of(result.script()));
  }

  @Test
  void readsEmptyTexts() {
    for (String text : List.of("", "\n", "# only a comment", "  \r\n\t")) {
      ParseResult result = ScriptParser.parseProgram(Source.of("empty", text));
      assertTrue(result.ok(), text);
      assertTrue(result.script().statements().isEmpty(), text);
    }
  }

  @Test
  void survivesBytesThatAreNotAsciiInCommentsAndLabels() {
    byte[] text = "# \u00E9\uAC00\n$ 1 \"a \u2254 b\"\nx = 1".getBytes(StandardCharsets.UTF_8);
    assertTrue(ScriptParser.parseProgram(Source.of("s", text)).ok());
  }

  private static void assertShape(String shape, String text) {
    ParseResult result = ScriptParser.parseProgram(Source.of("test", text));
    assertEquals(List.of(), result.diagnostics());
    assertEquals(shape, TreeShape.of(result.script()));
  }
}
