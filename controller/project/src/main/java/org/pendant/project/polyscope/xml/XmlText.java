package org.pendant.project.polyscope.xml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * XML writer: writes XML, indented by two blanks, and knows the paths of elements for references.
 */
public final class XmlText {
  private final StringBuilder out = new StringBuilder();
  private final List<Level> open = new ArrayList<>(List.of(new Level("", 1)));
  private final Map<String, List<String>> shared = new HashMap<>();
  private boolean tagOpen;

  /** The name of the next element, which has its own as its class; empty for its own. */
  private String roleName = "";

  /** An open element: its step in paths, and how many of each name are in it so far. */
  private record Level(String step, Map<String, Integer> counts) {
    Level(String name, int number) {
      this(number == 1 ? name : name + "[" + number + "]", new HashMap<>());
    }
  }

  /**
   * Begins an element.
   *
   * @param attributes names and values in turn
   */
  public XmlText open(String name, String... attributes) {
    line();
    String tag = tag(name);
    roleName = "";
    Map<String, Integer> counts = open.getLast().counts();
    open.add(new Level(tag, counts.merge(tag, 1, Integer::sum)));
    out.append('<').append(tag);
    tagOpen = true;
    if (!tag.equals(name)) {
      attribute("class", name);
    }
    for (int i = 0; i < attributes.length; i += 2) {
      attribute(attributes[i], attributes[i + 1]);
    }
    return this;
  }

  /**
   * Has the next element that is begun called by the part that it plays in the one around it, with
   * what it is as its class.
   */
  public XmlText role(String name) {
    roleName = name;
    return this;
  }

  private String tag(String name) {
    return roleName.isEmpty() ? name : roleName;
  }

  /** Adds an attribute to the element that was just begun. */
  public XmlText attribute(String name, String value) {
    out.append(' ').append(name).append("=\"");
    escape(value, true);
    out.append('"');
    return this;
  }

  /** Ends the innermost element. */
  public XmlText close() {
    String step = open.removeLast().step();
    if (tagOpen) {
      out.append("/>\n");
      tagOpen = false;
    } else {
      indent();
      out.append("</").append(nameOf(step)).append(">\n");
    }
    return this;
  }

  /** An element without anything in it. */
  public XmlText leaf(String name, String... attributes) {
    return open(name, attributes).close();
  }

  /** An element with a text in it. */
  public XmlText text(String name, String text, String... attributes) {
    if (text.isEmpty()) {
      return leaf(name, attributes);
    }
    open(name, attributes);
    out.append('>');
    escape(text, false);
    out.append("</").append(name).append(">\n");
    tagOpen = false;
    open.removeLast();
    return this;
  }

  /** An element as it is, to the letter. */
  public XmlText raw(String name, String xml) {
    line();
    open.getLast().counts().merge(name, 1, Integer::sum);
    indentless(xml);
    return this;
  }

  private void indentless(String xml) {
    out.append(xml).append('\n');
  }

  /** A comment; must not hold two hyphens. */
  public XmlText comment(String text) {
    line();
    out.append("<!--").append(text).append("-->\n");
    return this;
  }

  /**
   * Whether an element of this name, in the one that is open now, would be the first that stands
   * for something; if not, a reference to the first is written.
   *
   * @param key of what it stands for
   */
  public boolean first(String name, String key) {
    List<String> target = shared.get(key);
    if (target == null) {
      String tag = tag(name);
      int number = 1 + open.getLast().counts().getOrDefault(tag, 0);
      List<String> path = new ArrayList<>(steps());
      path.add(new Level(tag, number).step());
      shared.put(key, path);
      return true;
    }
    leaf(name, "reference", relative(target));
    return false;
  }

  /** How many elements are open. */
  public int depth() {
    return open.size() - 1;
  }

  private List<String> steps() {
    return open.stream().skip(1).map(Level::step).toList();
  }

  private String relative(List<String> target) {
    List<String> here = steps();
    int common = 0;
    while (common < here.size()
        && common < target.size()
        && here.get(common).equals(target.get(common))) {
      common++;
    }
    // one more up than there are elements open: the path begins at the element that carries it
    String up = "../".repeat(here.size() - common + 1);
    return up.substring(0, common == target.size() ? up.length() - 1 : up.length())
        + String.join("/", target.subList(common, target.size()));
  }

  private void line() {
    if (tagOpen) {
      out.append(">\n");
      tagOpen = false;
    }
    indent();
  }

  private void indent() {
    out.append("  ".repeat(open.size() - 1));
  }

  private static String nameOf(String step) {
    int bracket = step.indexOf('[');
    return bracket < 0 ? step : step.substring(0, bracket);
  }

  private void escape(String text, boolean inQuotes) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '&' -> out.append("&amp;");
        case '<' -> out.append("&lt;");
        case '>' -> out.append("&gt;");
        case '"' -> out.append(inQuotes ? "&quot;" : "\"");
        case '\r' -> out.append("&#13;");
        case '\n' -> out.append(inQuotes ? "&#10;" : "\n");
        case '\t' -> out.append(inQuotes ? "&#9;" : "\t");
        default -> out.append(allowed(text, i) ? c : '?');
      }
    }
  }

  /** XML has no way to write most control characters, nor half characters. */
  private static boolean allowed(String text, int at) {
    char c = text.charAt(at);
    if (Character.isHighSurrogate(c)) {
      return at + 1 < text.length() && Character.isLowSurrogate(text.charAt(at + 1));
    }
    if (Character.isLowSurrogate(c)) {
      return at > 0 && Character.isHighSurrogate(text.charAt(at - 1));
    }
    return c >= ' ' && c < 0xfffe;
  }

  @Override
  public String toString() {
    return out.toString();
  }
}
