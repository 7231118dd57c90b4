package org.pendant.command.comparison;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.pendant.recording.compare.Difference;
import org.pendant.recording.compare.RunComparison;

/** Comparison as JSON: everything that the tables have, with all digits. */
public final class ComparisonJson {
  private ComparisonJson() {}

  /** The text of the file. */
  public static String of(ComparedRun run) {
    RunComparison comparison = run.comparison();
    return "{\n  \"recording\": "
        + text(run.recording())
        + ",\n  \"program\": "
        + text(run.program())
        + ",\n  \"robot\": "
        + text(run.robot())
        + ",\n  \"payload\": "
        + text(run.payload())
        + ",\n  \"rows\": "
        + comparison.recorded().rows()
        + ",\n  \"shift_s\": "
        + number(comparison.shiftS())
        + ",\n  \"figures\": "
        + list(
            comparison.differences().stream()
                .filter(Difference.Figure.class::isInstance)
                .map(each -> figure((Difference.Figure) each))
                .toList())
        + ",\n  \"residuals\": "
        + list(
            comparison.differences().stream()
                .filter(Difference.Residual.class::isInstance)
                .map(each -> residual((Difference.Residual) each))
                .toList())
        + ",\n  \"limits\": "
        + list(run.limits().stream().map(ComparisonJson::limit).toList())
        + ",\n  \"notes\": "
        + list(comparison.notes().stream().map(ComparisonJson::text).toList())
        + "\n}\n";
  }

  private static String figure(Difference.Figure each) {
    return "{\"name\": "
        + text(each.name())
        + ", \"unit\": "
        + text(each.unit())
        + ", \"recorded\": "
        + number(each.recorded())
        + ", \"pendant\": "
        + number(each.pendant())
        + ", \"error\": "
        + number(each.error())
        + "}";
  }

  private static String residual(Difference.Residual each) {
    return "{\"name\": "
        + text(each.name())
        + ", \"unit\": "
        + text(each.unit())
        + ", \"least\": "
        + number(each.least())
        + ", \"most\": "
        + number(each.most())
        + ", \"mean\": "
        + number(each.mean())
        + ", \"rms\": "
        + number(each.rms())
        + ", \"largest\": "
        + number(each.largest())
        + "}";
  }

  private static String limit(ComparedRun.Limit each) {
    return "{\"name\": "
        + text(each.name())
        + ", \"most\": "
        + number(each.most())
        + ", \"size\": "
        + number(each.size())
        + ", \"kept\": "
        + each.kept()
        + "}";
  }

  private static String list(List<String> elements) {
    return elements.isEmpty()
        ? "[]"
        : elements.stream().collect(Collectors.joining(",\n    ", "[\n    ", "\n  ]"));
  }

  private static String number(double value) {
    return Double.isFinite(value) ? Double.toString(value) : "null";
  }

  private static String text(String text) {
    StringBuilder json = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"' || c == '\\') {
        json.append('\\').append(c);
      } else if (c < ' ') {
        json.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
      } else {
        json.append(c);
      }
    }
    return json.append('"').toString();
  }
}
