package org.pendant.testing.coverage.report;

import java.io.StringWriter;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.DecisionCoverage;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.FunctionCoverage;
import org.pendant.testing.coverage.LineCoverage;
import org.pendant.testing.coverage.Share;

/**
 * Cobertura coverage: coverage as XML by Cobertura's {@code coverage-04.dtd}. Folders are its
 * packages, files its classes, and hits are tests that reach a line. The time of the report is left
 * at 0, so that the same coverage gives the same bytes.
 */
public final class CoberturaCoverage {
  private static final String DOCTYPE =
      "<!DOCTYPE coverage SYSTEM \"http://cobertura.sourceforge.net/xml/coverage-04.dtd\">";

  private final XMLStreamWriter xml;

  private CoberturaCoverage(XMLStreamWriter xml) {
    this.xml = xml;
  }

  /** The document; its encoding is UTF-8. */
  public static String of(CoverageReport report) {
    StringWriter text = new StringWriter();
    try {
      XMLStreamWriter writer = XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(text);
      new CoberturaCoverage(writer).write(report);
      writer.close();
    } catch (XMLStreamException e) {
      throw new IllegalStateException("a report cannot be written into memory", e);
    }
    return text.toString();
  }

  private void write(CoverageReport report) throws XMLStreamException {
    xml.writeStartDocument("UTF-8", "1.0");
    xml.writeCharacters("\n");
    xml.writeDTD(DOCTYPE);
    begin(0, "coverage");
    rates(report.reachedLines(), report.branchWays());
    counts("lines", report.reachedLines());
    counts("branches", report.branchWays());
    xml.writeAttribute("complexity", "0");
    xml.writeAttribute("version", "pendant");
    xml.writeAttribute("timestamp", "0");
    begin(1, "sources");
    begin(2, "source");
    xml.writeCharacters(".");
    xml.writeEndElement();
    end(1);
    begin(1, "packages");
    Map<String, List<FileCoverage>> folders =
        report.files().stream()
            .collect(
                Collectors.groupingBy(
                    file -> folder(file.file()), TreeMap::new, Collectors.toList()));
    for (Map.Entry<String, List<FileCoverage>> folder : folders.entrySet()) {
      folder(folder.getKey(), folder.getValue());
    }
    end(1);
    end(0);
    xml.writeCharacters("\n");
    xml.writeEndDocument();
  }

  private static String folder(String file) {
    int slash = Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\'));
    return slash < 0 ? "" : file.substring(0, slash);
  }

  private void folder(String name, List<FileCoverage> files) throws XMLStreamException {
    begin(2, "package");
    xml.writeAttribute("name", name);
    Share lines = Share.NONE;
    Share branches = Share.NONE;
    for (FileCoverage file : files) {
      lines = lines.plus(file.reachedLines());
      branches = branches.plus(file.branchWays());
    }
    rates(lines, branches);
    xml.writeAttribute("complexity", "0");
    begin(3, "classes");
    for (FileCoverage file : files) {
      file(file);
    }
    end(3);
    end(2);
  }

  private void file(FileCoverage file) throws XMLStreamException {
    begin(4, "class");
    xml.writeAttribute(
        "name", file.file().substring(folder(file.file()).length()).replaceFirst("^[/\\\\]", ""));
    xml.writeAttribute("filename", file.file());
    rates(file.reachedLines(), file.branchWays());
    xml.writeAttribute("complexity", "0");
    begin(5, "methods");
    for (FunctionCoverage function : file.functions()) {
      function(function);
    }
    end(5);
    begin(5, "lines");
    Map<Integer, List<DecisionCoverage>> branches =
        file.branches().stream().collect(Collectors.groupingBy(DecisionCoverage::line));
    for (LineCoverage line : file.lines()) {
      line(line, branches.getOrDefault(line.line(), List.of()));
    }
    end(5);
    end(4);
  }

  private void function(FunctionCoverage function) throws XMLStreamException {
    begin(6, "method");
    xml.writeAttribute("name", function.name());
    xml.writeAttribute("signature", "");
    rates(new Share(function.reached() ? 1 : 0, 1), Share.NONE);
    xml.writeAttribute("complexity", "0");
    begin(7, "lines");
    indent(8);
    xml.writeEmptyElement("line");
    xml.writeAttribute("number", Integer.toString(function.line()));
    xml.writeAttribute("hits", Integer.toString(function.tests().size()));
    end(7);
    end(6);
  }

  private void line(LineCoverage line, List<DecisionCoverage> branches) throws XMLStreamException {
    if (branches.isEmpty()) {
      indent(6);
      xml.writeEmptyElement("line");
    } else {
      begin(6, "line");
    }
    xml.writeAttribute("number", Integer.toString(line.line()));
    xml.writeAttribute("hits", Integer.toString(line.tests().size()));
    xml.writeAttribute("branch", Boolean.toString(!branches.isEmpty()));
    if (branches.isEmpty()) {
      return;
    }
    Share ways = Share.NONE;
    for (DecisionCoverage branch : branches) {
      ways = ways.plus(branch.ways());
    }
    xml.writeAttribute(
        "condition-coverage", percent(ways) + " (" + ways.reached() + "/" + ways.total() + ")");
    begin(7, "conditions");
    for (int i = 0; i < branches.size(); i++) {
      indent(8);
      xml.writeEmptyElement("condition");
      xml.writeAttribute("number", Integer.toString(i));
      xml.writeAttribute("type", "jump");
      xml.writeAttribute("coverage", percent(branches.get(i).ways()));
    }
    end(7);
    end(6);
  }

  private static String percent(Share share) {
    return (int) Math.floor(100 * share.rate()) + "%";
  }

  private void rates(Share lines, Share branches) throws XMLStreamException {
    xml.writeAttribute("line-rate", rate(lines));
    xml.writeAttribute("branch-rate", rate(branches));
  }

  private static String rate(Share share) {
    return String.format(Locale.ROOT, "%.4f", Math.floor(1e4 * share.rate()) / 1e4);
  }

  private void counts(String what, Share share) throws XMLStreamException {
    xml.writeAttribute(what + "-covered", Integer.toString(share.reached()));
    xml.writeAttribute(what + "-valid", Integer.toString(share.total()));
  }

  private void begin(int depth, String element) throws XMLStreamException {
    indent(depth);
    xml.writeStartElement(element);
  }

  private void end(int depth) throws XMLStreamException {
    indent(depth);
    xml.writeEndElement();
  }

  private void indent(int depth) throws XMLStreamException {
    xml.writeCharacters("\n" + "  ".repeat(depth));
  }
}
