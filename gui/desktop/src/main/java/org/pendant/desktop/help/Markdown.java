package org.pendant.desktop.help;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.kit.theme.Markup;

/** Markdown, as much of it as the documentation uses, as HTML that a text component can show. */
final class Markdown {
  private static final Pattern CODE = Pattern.compile("`([^`]+)`");
  private static final Pattern LINK = Pattern.compile("\\[([^\\]]+)]\\(([^)\\s]+)\\)");
  private static final Pattern BOLD = Pattern.compile("\\*\\*([^*]+)\\*\\*");
  private static final Pattern ITALIC = Pattern.compile("(?<![*\\w])\\*([^*\\s][^*]*)\\*");
  private static final Pattern ITEM = Pattern.compile("(?:[-*]|\\d+\\.) (.*)");

  private final StringBuilder html = new StringBuilder();
  private final List<String> paragraph = new ArrayList<>();
  private String block = "";

  private Markdown() {}

  /** A page without its head. */
  static String html(String markdown) {
    Markdown page = new Markdown();
    Iterator<String> lines = markdown.lines().iterator();
    while (lines.hasNext()) {
      String line = lines.next();
      if (line.startsWith("```")) {
        page.code(lines);
      } else {
        page.line(line);
      }
    }
    page.leave();
    return page.html.toString();
  }

  private void code(Iterator<String> lines) {
    leave();
    html.append("<pre>");
    while (lines.hasNext()) {
      String line = lines.next();
      if (line.startsWith("```")) {
        break;
      }
      html.append(Markup.escaped(line)).append('\n');
    }
    html.append("</pre>\n");
  }

  private void line(String line) {
    Matcher item = ITEM.matcher(line);
    if (line.isBlank()) {
      leave();
    } else if (line.startsWith("#")) {
      heading(line);
    } else if (line.startsWith("|")) {
      row(line);
    } else if (item.matches()) {
      flush();
      enter("ul");
      paragraph.add(item.group(1));
    } else if (!line.startsWith("![")) {
      if (block.equals("table")) {
        leave();
      }
      paragraph.add(line.strip());
    }
  }

  private void heading(String line) {
    leave();
    int level = line.indexOf(' ');
    String text = line.substring(level + 1).strip();
    html.append("<a name=\"").append(anchor(text)).append("\"></a>");
    html.append("<h").append(level).append('>').append(inline(text));
    html.append("</h").append(level).append(">\n");
  }

  /** How links name a heading. */
  static String anchor(String heading) {
    return heading.toLowerCase(Locale.ROOT).replaceAll("[^\\w\\- ]", "").replace(' ', '-');
  }

  private void row(String line) {
    flush();
    if (line.matches("[|\\s:-]+") && line.contains("-")) {
      return;
    }
    enter("table");
    html.append("<tr>");
    for (String cell : line.strip().replaceAll("^\\||\\|$", "").split("(?<!\\\\)\\|", -1)) {
      html.append("<td valign=\"top\">").append(inline(cell.strip().replace("\\|", "|")));
      html.append("</td>");
    }
    html.append("</tr>\n");
  }

  private void enter(String wanted) {
    if (!block.equals(wanted)) {
      leave();
      block = wanted;
      html.append('<').append(wanted).append(">\n");
    }
  }

  private void leave() {
    flush();
    if (!block.isEmpty()) {
      html.append("</").append(block).append(">\n");
      block = "";
    }
  }

  private void flush() {
    if (!paragraph.isEmpty()) {
      String tag = block.equals("ul") ? "li" : "p";
      html.append('<').append(tag).append('>').append(inline(String.join(" ", paragraph)));
      html.append("</").append(tag).append(">\n");
      paragraph.clear();
    }
  }

  /** Code first: nothing in it means anything else. */
  private static String inline(String text) {
    StringBuilder line = new StringBuilder();
    Matcher code = CODE.matcher(text);
    int end = 0;
    while (code.find()) {
      line.append(marked(text.substring(end, code.start())));
      line.append("<code>").append(Markup.escaped(code.group(1))).append("</code>");
      end = code.end();
    }
    return links(line.append(marked(text.substring(end))).toString());
  }

  private static String links(String html) {
    return LINK.matcher(html).replaceAll("<a href=\"$2\">$1</a>");
  }

  private static String marked(String text) {
    String bold = BOLD.matcher(Markup.escaped(text)).replaceAll("<b>$1</b>");
    return ITALIC.matcher(bold).replaceAll("<i>$1</i>");
  }
}
