package org.pendant.testing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.pendant.testing.SuiteResult;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

class JunitReportTest {
  /** What the schema of Jenkins lets be in what, and properties of test cases, which came later. */
  private static final Map<String, Set<String>> CHILDREN =
      Map.of(
          "testsuites", Set.of("testsuite"),
          "testsuite", Set.of("properties", "testcase"),
          "properties", Set.of("property"),
          "testcase", Set.of("properties", "skipped", "error", "failure", "system-out"),
          "property", Set.of(),
          "skipped", Set.of(),
          "error", Set.of(),
          "failure", Set.of(),
          "system-out", Set.of());

  private static final Map<String, List<String>> REQUIRED =
      Map.of(
          "testsuites", List.of("name", "tests", "failures", "errors", "time"),
          "testsuite", List.of("name", "tests", "failures", "errors", "skipped", "time", "file"),
          "testcase", List.of("classname", "name", "time", "file"),
          "property", List.of("name", "value"),
          "skipped", List.of("message"),
          "error", List.of("message", "type"),
          "failure", List.of("message", "type"));

  @Test
  void hasASuiteForEachFileAndACaseForEachTest() throws Exception {
    assertEquals(
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="pendant test" tests="8" failures="1" errors="3" time="3.596">
          <testsuite name="cell/pick_test.script" tests="3" failures="0" errors="0" skipped="1"\
         time="2.450" file="cell/pick_test.script">
            <properties>
              <property name="seed" value="4711"/>
            </properties>
            <testcase classname="cell.pick_test" name="test_pick" time="1.250"\
         file="cell/pick_test.script" line="9"/>
            <testcase classname="cell.pick_test" name="test_place" time="1.200"\
         file="cell/pick_test.script" line="9"/>
            <testcase classname="cell.pick_test" name="test_two_arms" time="0.000"\
         file="cell/pick_test.script" line="9">
              <skipped message="there is one arm; see #7"/>
            </testcase>
          </testsuite>
          <testsuite name="cell/grip_test.script" tests="4" failures="1" errors="2" skipped="0"\
         time="1.146" file="cell/grip_test.script">
            <properties>
              <property name="seed" value="4711"/>
            </properties>
            <testcase classname="cell.grip_test" name="test_open" time="0.046"\
         file="cell/grip_test.script" line="9"/>
            <testcase classname="cell.grip_test" name="test_grip[0.05, True]" time="0.100"\
         file="cell/grip_test.script" line="2">
              <properties>
                <property name="tag" value="gripper"/>
                <property name="tag" value="slow"/>
              </properties>
              <failure message="width is 0.05 m, expected 0.04 m" type="assertion-failed">\
        cell/grip_test.script:2:3: error: width is 0.05 m, expected 0.04 m
          | within 0.001 m
          assert_near(width, 0.04, 0.001)
          ^
          in close, cell/grip_test.script:2:3
          in test_grip, cell/grip_test.script:6:3</failure>
              <system-out>closing
        width 0.05
        </system-out>
            </testcase>
            <testcase classname="cell.grip_test" name="test_force" time="0.500"\
         file="cell/grip_test.script" line="10">
              <error message="force_mode: 4 arguments are missing" type="missing-argument">\
        cell/grip_test.script:10:3: error: force_mode: 4 arguments are missing
          force_mode(p[0,0,0,0,0,0])
          ^</error>
            </testcase>
            <testcase classname="cell.grip_test" name="test_forever" time="0.500"\
         file="cell/grip_test.script" line="9">
              <error message="ran longer than 60 s of robot time" type="timed-out">\
        cell/grip_test.script:9:1: error: ran longer than 60 s of robot time</error>
            </testcase>
          </testsuite>
          <testsuite name="cell/old_test.script" tests="1" failures="0" errors="1" skipped="0"\
         time="0.000" file="cell/old_test.script">
            <properties>
              <property name="seed" value="4711"/>
            </properties>
            <testcase classname="cell.old_test" name="(the file itself)" time="0.000"\
         file="cell/old_test.script">
              <error message="no test of the file could run" type="broken-file">\
        cell/old_test.script:3:5: error: `movee` is not known
          movee(q)
          ^~~~~</error>
            </testcase>
          </testsuite>
        </testsuites>
        """,
        text(SampleSuite.suite()));
  }

  @Test
  void hasTheStructureThatJenkinsReads() throws Exception {
    Element root = parsed(SampleSuite.suite());
    assertEquals("testsuites", root.getTagName());
    check(root);
  }

  @Test
  void itsSumsAreThoseOfItsSuites() throws Exception {
    Element root = parsed(SampleSuite.suite());
    for (String each : List.of("tests", "failures", "errors")) {
      int sum =
          elements(root).stream()
              .mapToInt(suite -> Integer.parseInt(suite.getAttribute(each)))
              .sum();
      assertEquals(root.getAttribute(each), Integer.toString(sum), each);
    }
  }

  @Test
  void keepsTextsWholeThatAreSpecialInXml() throws Exception {
    String message = "]]> <b> & \"q\" 'x' é \uD83E\uDD16";
    Element root = parsed(SampleSuite.of(SampleSuite.failed(message, List.of("]]>", "<a>&b;"))));
    Element failure = (Element) root.getElementsByTagName("failure").item(0);
    assertEquals(message, failure.getAttribute("message"));
    assertEquals("]]>\n<a>&b;\n", root.getElementsByTagName("system-out").item(0).getTextContent());
  }

  @Test
  void replacesCharactersThatXmlForbids() throws Exception {
    String message = "\u0000 \u001b \uD800 \uFFFE \uFFFF \r";
    Element root = parsed(SampleSuite.of(SampleSuite.failed(message, List.of(message))));
    assertEquals(
        "\\x00 \\x1b \uFFFD \uFFFD \uFFFD \\x0d",
        ((Element) root.getElementsByTagName("failure").item(0)).getAttribute("message"));
  }

  @Test
  void namesClassesAsFilesInFoldersWithoutWhatIsAboveThem() {
    assertEquals("cell.pick_test", JunitReport.className("../cell/./pick_test.script"));
    assertEquals("a_b.v1_2_test", JunitReport.className("a.b\\v1.2_test.script"));
    assertEquals("home.me.x_test", JunitReport.className("/home/me/x_test.script"));
    assertEquals("tests", JunitReport.className("."));
  }

  @Test
  void boundsOutputAndSaysThatThereWasMore() throws Exception {
    List<String> output = new ArrayList<>(Collections.nCopies(100_000, "x".repeat(100)));
    output.add("\u0001".repeat(10_000_000));
    output.add("the last one");
    String text = text(SampleSuite.of(SampleSuite.failed("m", output)));
    assertTrue(text.length() < 200_000, text.length() + " characters");
    assertTrue(text.contains("<system-out>(output, last "), text.substring(0, 2_000));
    assertTrue(text.contains("\nthe last one\n</system-out>"));
  }

  @Test
  void growsWithTheNumberOfResultsAndNotFaster() throws Exception {
    int small = text(SampleSuite.many(1_000)).length();
    int large = text(SampleSuite.many(10_000)).length();
    assertTrue(large < 11 * small, small + " and " + large);
  }

  @Test
  void tellsThatTheDiskIsFullAsItIs() {
    OutputStream full =
        new OutputStream() {
          @Override
          public void write(int b) throws IOException {
            throw new IOException("No space left on device");
          }
        };
    IOException thrown =
        assertThrows(
            IOException.class,
            () -> JunitReport.write(SampleSuite.many(1_000), SampleSuite::source, full));
    assertEquals("No space left on device", thrown.getMessage());
  }

  private static void check(Element element) {
    for (String each : REQUIRED.getOrDefault(element.getTagName(), List.of())) {
      assertTrue(element.hasAttribute(each), element.getTagName() + " without " + each);
    }
    for (Element each : elements(element)) {
      assertTrue(
          CHILDREN.get(element.getTagName()).contains(each.getTagName()),
          each.getTagName() + " in " + element.getTagName());
      check(each);
    }
  }

  private static List<Element> elements(Element parent) {
    List<Element> elements = new ArrayList<>();
    for (Node each = parent.getFirstChild(); each != null; each = each.getNextSibling()) {
      if (each instanceof Element element) {
        elements.add(element);
      }
    }
    return elements;
  }

  private static Element parsed(SuiteResult suite) throws Exception {
    byte[] bytes = text(suite).getBytes(StandardCharsets.UTF_8);
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new ByteArrayInputStream(bytes))
        .getDocumentElement();
  }

  private static String text(SuiteResult suite) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    JunitReport.write(suite, SampleSuite::source, out);
    return out.toString(StandardCharsets.UTF_8);
  }
}
