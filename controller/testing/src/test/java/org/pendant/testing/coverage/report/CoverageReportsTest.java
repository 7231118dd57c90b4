package org.pendant.testing.coverage.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SortedMap;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.pendant.testing.coverage.CoverageCollector;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.FunctionCoverage;
import org.pendant.testing.coverage.LineCoverage;
import org.pendant.testing.coverage.NodeCoverage;
import org.pendant.testing.coverage.SampleCoverage;
import org.pendant.testing.coverage.Share;
import org.pendant.testing.coverage.TreeCoverage;
import org.pendant.text.Language;
import org.pendant.text.Texts;
import org.w3c.dom.Document;
import org.xml.sax.ErrorHandler;
import org.xml.sax.InputSource;
import org.xml.sax.SAXParseException;

/** The forms that coverage is told in, to the byte. */
class CoverageReportsTest {
  private static String expected(String name) throws IOException {
    try (InputStream in = CoverageReportsTest.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** A file besides the sample, and a tree. */
  private static CoverageReport more() {
    FileCoverage other =
        new FileCoverage(
            "a.script",
            List.of("def a():", "  x = 1", "end"),
            List.of(new LineCoverage(2, new Share(0, 1), List.of())),
            List.of(new FunctionCoverage("a", 1, List.of())),
            List.of(),
            List.of());
    TreeCoverage tree =
        new TreeCoverage(
            "stack.pendant",
            List.of(
                new NodeCoverage(1, "Move", List.of("t")), new NodeCoverage(4, "If", List.of())));
    return new CoverageReport(
        SampleCoverage.pick().tests(),
        List.of(other, SampleCoverage.pick().files().getFirst()),
        List.of(tree));
  }

  @Test
  void tableHasARowForEachFile() {
    assertEquals(
        """
        file              statements  branches  conditions  functions  missing lines
        a.script               0.0 %         -           -      0.0 %  2
        cell/pick.script      75.0 %     100 %      50.0 %     66.6 %  6-10
        all                   66.6 %     100 %      50.0 %     50.0 %
        stack.pendant: 1 of 2 nodes reached; missing: 4 "If"
        """,
        CoverageTable.of(more()));
  }

  @Test
  void columnsStandUnderTheirHeadingsInEveryLanguage() {
    assertEquals(
        """
        Datei             Anweisungen  Zweige  Bedingungen  Funktionen  fehlende Zeilen
        a.script                0.0 %       -            -       0.0 %  2
        cell/pick.script       75.0 %   100 %       50.0 %      66.6 %  6-10
        alle                   66.6 %   100 %       50.0 %      50.0 %
        stack.pendant: 1 von 2 Knoten erreicht; es fehlen: 4 "If"
        """,
        CoverageTable.of(more(), Texts.of(CoverageTable.class, Language.GERMAN)));
    assertEquals(
        """
        文件                语句   分支    条件    函数  未到达的行
        a.script           0.0 %      -       -   0.0 %  2
        cell/pick.script  75.0 %  100 %  50.0 %  66.6 %  6-10
        全部              66.6 %  100 %  50.0 %  50.0 %
        stack.pendant：到达 1/2 个节点；未到达：4 "If"
        """,
        CoverageTable.of(more(), Texts.of(CoverageTable.class, Language.CHINESE)));
  }

  @Test
  void oneFileNeedsNoSum() {
    assertEquals(2, CoverageTable.of(SampleCoverage.pick()).lines().count());
  }

  @Test
  void nothingIsToldOfNothing() {
    CoverageReport nothing = new CoverageCollector().report();
    assertEquals("", CoverageTable.of(nothing));
    assertEquals("", LcovCoverage.of(nothing));
    assertTrue(HtmlCoverage.of(nothing).get("index.html").contains("0 tests"));
  }

  @Test
  void tracefileOfLcovCountsTests() {
    assertEquals(
        """
        TN:
        SF:cell/pick.script
        FN:1,pick
        FN:2,grip
        FN:8,unused
        FNDA:2,pick
        FNDA:2,grip
        FNDA:0,unused
        FNF:3
        FNH:2
        BRDA:3,0,0,1
        BRDA:3,0,1,1
        BRDA:13,0,0,1
        BRDA:13,0,1,2
        BRF:4
        BRH:4
        DA:3,2
        DA:4,1
        DA:6,0
        DA:10,0
        DA:12,2
        DA:13,2
        DA:14,1
        DA:16,2
        LF:8
        LH:6
        end_of_record
        """,
        LcovCoverage.of(SampleCoverage.pick()));
  }

  @Test
  void functionsOfOneNameAreToldApartInLcov() {
    FileCoverage file =
        new FileCoverage(
            "a.script",
            List.of(),
            List.of(),
            List.of(
                new FunctionCoverage("f", 1, List.of()), new FunctionCoverage("f", 9, List.of())),
            List.of(),
            List.of());
    String lcov = LcovCoverage.of(new CoverageReport(List.of(), List.of(file), List.of()));
    assertTrue(lcov.contains("FN:1,f:1\nFN:9,f:9\nFNDA:0,f:1\nFNDA:0,f:9\n"), lcov);
  }

  @Test
  void coberturaIsValidByItsDtd() throws Exception {
    String xml = CoberturaCoverage.of(more());
    assertEquals(expected("cobertura.xml"), xml);
    DocumentBuilderFactory factory = DocumentBuilderFactory.newDefaultInstance();
    factory.setValidating(true);
    DocumentBuilder builder = factory.newDocumentBuilder();
    String dtd = expected("coverage-04.dtd");
    builder.setEntityResolver((id, name) -> new InputSource(new StringReader(dtd)));
    builder.setErrorHandler(new Strict());
    Document document =
        builder.parse(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
    assertEquals(2, document.getElementsByTagName("class").getLength());
  }

  private static final class Strict implements ErrorHandler {
    @Override
    public void warning(SAXParseException exception) throws SAXParseException {
      throw exception;
    }

    @Override
    public void error(SAXParseException exception) throws SAXParseException {
      throw exception;
    }

    @Override
    public void fatalError(SAXParseException exception) throws SAXParseException {
      throw exception;
    }
  }

  @Test
  void pagesAreOneForEachFileAndOneForAll() throws IOException {
    SortedMap<String, String> pages = HtmlCoverage.of(more());
    assertEquals(
        List.of("a.script.html", "cell_pick.script.html", "coverage.css", "index.html"),
        List.copyOf(pages.keySet()));
    assertEquals(expected("index.html"), pages.get("index.html"));
    assertEquals(expected("pick.html"), pages.get("cell_pick.script.html"));
  }

  @Test
  void pagesNeedNothingFromElsewhere() {
    HtmlCoverage.of(more())
        .forEach(
            (name, page) -> {
              assertFalse(page.contains("://"), name);
              assertFalse(page.contains("<script"), name);
            });
    assertTrue(HtmlCoverage.of(more()).get("coverage.css").contains("prefers-color-scheme: dark"));
  }

  @Test
  void filesWithNamesThatPagesWouldShareHavePagesOfTheirOwn() {
    FileCoverage one = more().files().getFirst();
    List<FileCoverage> files =
        List.of(named(one, "a/b"), named(one, "a_b"), named(one, "index"), named(one, "../x"));
    assertEquals(
        List.of("__x.html", "a_b-2.html", "a_b.html", "coverage.css", "index-2.html", "index.html"),
        List.copyOf(HtmlCoverage.of(new CoverageReport(List.of(), files, List.of())).keySet()));
  }

  private static FileCoverage named(FileCoverage file, String name) {
    return new FileCoverage(
        name, file.text(), file.lines(), file.functions(), file.branches(), file.conditions());
  }
}
