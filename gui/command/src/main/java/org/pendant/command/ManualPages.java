package org.pendant.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SequencedMap;
import org.pendant.command.service.Version;
import org.pendant.text.Texts;

/**
 * Manual pages for {@code man}, from what the subcommands declare: {@code pendant.1}, and one for
 * each of them such as {@code pendant-run.1}.
 */
public final class ManualPages {
  private final List<Subcommand> subcommands;
  private final String heading;
  private final Texts usage = UsageTexts.english();

  /**
   * The pages.
   *
   * @param subcommands all that have one
   * @param date that they carry
   */
  ManualPages(List<Subcommand> subcommands, Instant date) {
    this.subcommands = List.copyOf(subcommands);
    String day = DateTimeFormatter.ISO_LOCAL_DATE.withZone(ZoneOffset.UTC).format(date);
    heading = " 1 " + day + " " + quoted("Pendant " + Version.number());
  }

  /** Writes them into the folder, and with the date, that {@code words} name. */
  public static void main(String[] words) throws IOException {
    List<Subcommand> all = new Pendant(Console.ofProcess()).subcommands();
    Path folder = Path.of(words[0]);
    for (Map.Entry<String, String> page :
        new ManualPages(all, Instant.parse(words[1])).all().entrySet()) {
      Files.writeString(folder.resolve(page.getKey()), page.getValue());
    }
  }

  /** Names of files and what is in them. */
  SequencedMap<String, String> all() {
    SequencedMap<String, String> pages = new LinkedHashMap<>();
    pages.put("pendant.1", String.join("\n", overview()) + "\n");
    for (Subcommand each : subcommands) {
      pages.put("pendant-" + each.name() + ".1", String.join("\n", page(each)) + "\n");
    }
    return pages;
  }

  private List<String> overview() {
    List<String> lines = new ArrayList<>();
    lines.add(".TH PENDANT" + heading);
    lines.add(".SH NAME");
    lines.add("pendant \\- run URScript programs on a robot controller inside");
    lines.add(".SH SYNOPSIS");
    lines.add(".B pendant");
    lines.add("[\\fIFILE\\fR...]");
    lines.add(".br");
    lines.add(".B pendant");
    lines.add("\\fICOMMAND\\fR [\\fIoptions\\fR] ...");
    lines.add(".SH DESCRIPTION");
    lines.add("Without a command the desktop is opened, with the files that are named.");
    lines.add(".SH COMMANDS");
    for (Subcommand each : subcommands) {
      lines.add(".TP");
      lines.add("\\fB" + text(each.name()) + "\\fR " + text(each.operands()));
      lines.add(text(each.summary(usage)) + ", see");
      lines.add(".BR pendant\\-" + text(each.name()) + " (1)");
    }
    lines.add(".SH OPTIONS");
    option(lines, Subcommand.HELP);
    option(lines, Pendant.VERSION);
    lines.add(".SH EXIT STATUS");
    lines.add("0 done, 1 a program, test or comparison failed, 2 wrong usage, 3 does not compile,");
    lines.add("4 out of time, 69 something that is needed is not there, 70 a fault in Pendant,");
    lines.add("130 and 143 after signals.");
    lines.add(".SH ENVIRONMENT");
    lines.add(".TP");
    lines.add(".B PENDANT_JAVA_OPTIONS");
    lines.add("more options for the Java that runs Pendant");
    lines.add(".TP");
    lines.add(".B PENDANT_LANGUAGE");
    lines.add("the language of commands and window: en, de or zh; English for commands without it");
    return lines;
  }

  private List<String> page(Subcommand subcommand) {
    List<String> lines = new ArrayList<>();
    lines.add(".TH PENDANT\\-" + text(subcommand.name().toUpperCase(Locale.ROOT)) + heading);
    lines.add(".SH NAME");
    lines.add("pendant\\-" + text(subcommand.name()) + " \\- " + text(subcommand.summary(usage)));
    lines.add(".SH SYNOPSIS");
    lines.add(".B pendant " + text(subcommand.name()));
    lines.add("[\\fIoptions\\fR] " + text(subcommand.operands()));
    lines.add(".SH OPTIONS");
    subcommand.options().forEach(option -> option(lines, option));
    option(lines, Subcommand.HELP);
    lines.add(".SH SEE ALSO");
    lines.add(".BR pendant (1)");
    return lines;
  }

  private void option(List<String> lines, Option option) {
    lines.add(".TP");
    String value = option.takesValue() ? " \\fI" + text(option.value()) + "\\fR" : "";
    lines.add("\\fB" + text(option.name()) + "\\fR" + value);
    lines.add(text(option.description(usage)));
  }

  /** As troff shows it: no hyphens for minus signs, no escapes, no requests where a line begins. */
  static String text(String words) {
    String escaped = words.replace("\\", "\\e").replace("-", "\\-");
    return escaped.startsWith(".") || escaped.startsWith("'") ? "\\&" + escaped : escaped;
  }

  private static String quoted(String words) {
    return "\"" + text(words).replace("\"", "\\(dq") + "\"";
  }
}
