package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.installation.ControlHost;

class ControlScriptTest {
  private static ControlScript of(String text) {
    return ControlScript.of(ControlHost.STANDARD, text);
  }

  private static List<String> numbered(List<ControlScript.Line> lines) {
    return lines.stream().map(each -> each.number() + " " + each.text()).toList();
  }

  @Test
  void whatIsBetweenTheMarksIsHeaderAndWhatFollowsIsForTheNodes() {
    ControlScript script =
        of("left out\n  # HEADER_BEGIN \ndef f():\nend\n# HEADER_END\n\nf()\r\nsync()");
    assertEquals(
        List.of("2   # HEADER_BEGIN ", "3 def f():", "4 end", "5 # HEADER_END"),
        numbered(script.header()));
    assertEquals(List.of("6 ", "7 f()", "8 sync()"), numbered(script.loop()));
  }

  @Test
  void severalHeadersAreOne() {
    ControlScript script =
        of("# HEADER_BEGIN\na = 1\n# HEADER_END\nb\n# HEADER_BEGIN\nc = 1\n# HEADER_END\nd");
    assertEquals(
        List.of("2 a = 1", "6 c = 1"),
        numbered(script.header()).stream().filter(each -> each.contains("=")).toList());
    assertEquals(List.of("4 b", "8 d"), numbered(script.loop()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "a\nb",
        "# HEADER_BEGIN\na",
        "a\n# HEADER_END\nb",
        "## HEADER_BEGIN\na\n# HEADER_END",
        "# HEADER_BEGIN now\na\n# HEADER_END"
      })
  void aTextWithoutBothMarksIsForTheNodesAsAWhole(String text) {
    ControlScript script = of(text);
    assertEquals(List.of(), script.header());
    assertEquals(
        text.lines().toList(), script.loop().stream().map(ControlScript.Line::text).toList());
  }

  @Test
  void saysWhereALineComesFrom() {
    assertEquals("line 12 of the script from 192.168.56.1:50002", of("a").place(12));
  }
}
