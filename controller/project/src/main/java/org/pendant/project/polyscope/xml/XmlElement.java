package org.pendant.project.polyscope.xml;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.xml.stream.XMLStreamReader;

/**
 * XML element of such a file. It notes which of its attributes and children have been asked for, so
 * that one can tell afterwards what has not been understood. Not for several threads.
 */
public final class XmlElement {
  private static final String REFERENCE = "reference";

  /** References to references; files have one or two in a row. */
  private static final int MAX_STEPS = 1000;

  /** From so many children on they are looked up by name. */
  private static final int MANY = 16;

  private final XmlSource source;
  private final XmlElement parent;
  private final String name;

  /** Names and values in turn. */
  private final String[] attributes;

  private final int begin;
  private final String comment;
  private List<XmlElement> children = List.of();
  private StringBuilder text = new StringBuilder(0);
  private int end;
  private Set<String> read = Set.of();

  /** Children by name, once one of many has been asked for. */
  private Map<String, List<XmlElement>> named = Map.of();

  private boolean seen;

  XmlElement(
      XmlSource source, XmlElement parent, XMLStreamReader reader, int begin, String comment) {
    this.source = source;
    this.parent = parent;
    this.begin = begin;
    this.comment = comment;
    name = reader.getLocalName();
    attributes = new String[2 * reader.getAttributeCount()];
    for (int i = 0; i < reader.getAttributeCount(); i++) {
      attributes[2 * i] = reader.getAttributeLocalName(i);
      attributes[2 * i + 1] = reader.getAttributeValue(i);
    }
    if (parent != null) {
      parent.add(this);
    }
  }

  private void add(XmlElement child) {
    if (children.isEmpty()) {
      children = new ArrayList<>(2);
      // text beside elements is only there to look nice
      text = new StringBuilder(0);
    }
    children.add(child);
  }

  void append(String more) {
    if (children.isEmpty()) {
      text.append(more);
    }
  }

  void close(int afterwards) {
    end = afterwards;
    text.trimToSize();
  }

  /** Its name. */
  public String name() {
    return name;
  }

  /** An attribute; empty if it has none of that name. */
  public Optional<String> attribute(String wanted) {
    for (int i = 0; i < attributes.length; i += 2) {
      if (attributes[i].equals(wanted)) {
        if (read.isEmpty()) {
          read = new HashSet<>(4);
        }
        read.add(wanted);
        return Optional.of(attributes[i + 1]);
      }
    }
    return Optional.empty();
  }

  /** An attribute; the empty text if it has none of that name. */
  public String text(String attribute) {
    return attribute(attribute).orElse("");
  }

  /** The names of its attributes, in order. */
  public List<String> attributeNames() {
    List<String> names = new ArrayList<>(attributes.length / 2);
    for (int i = 0; i < attributes.length; i += 2) {
      names.add(attributes[i]);
    }
    return names;
  }

  /** The text in it; empty when there are elements in it. */
  public String text() {
    return text.toString();
  }

  /** All elements in it, in order. */
  public List<XmlElement> children() {
    children.forEach(XmlElement::see);
    return Collections.unmodifiableList(children);
  }

  /** The elements of one name in it, in order. */
  public List<XmlElement> children(String wanted) {
    List<XmlElement> found = alike(wanted);
    found.forEach(XmlElement::see);
    return found;
  }

  private List<XmlElement> alike(String wanted) {
    if (children.size() < MANY) {
      return children.stream().filter(each -> each.name.equals(wanted)).toList();
    }
    if (named.isEmpty()) {
      named = children.stream().collect(Collectors.groupingBy(XmlElement::name));
    }
    return named.getOrDefault(wanted, List.of());
  }

  /** The first element of one of these names in it. */
  public Optional<XmlElement> child(String... wanted) {
    for (String each : wanted) {
      List<XmlElement> found = children(each);
      if (!found.isEmpty()) {
        return Optional.of(found.getFirst());
      }
    }
    return Optional.empty();
  }

  /** The comment right before it; empty if there is none. */
  public String comment() {
    return comment;
  }

  /** Its text in the file, to the letter, from its first to its last bracket. */
  public String raw() {
    return source.text().substring(begin, end);
  }

  /** Its line in the file, from 1. */
  public int line() {
    return source.line(begin);
  }

  /** Where it begins in its line, in characters from 1. */
  public int column() {
    return source.column(begin);
  }

  /** Names from the outermost element to this one, with numbers where several have one name. */
  public String path() {
    return parent == null ? name : parent.path() + "/" + step();
  }

  private String step() {
    List<XmlElement> alike = parent.alike(name);
    return alike.size() == 1 ? name : name + "[" + (1 + alike.indexOf(this)) + "]";
  }

  /** That this element makes the file unreadable. */
  public UnreadableFile wrong(String message) {
    return source.wrong(begin, message);
  }

  /**
   * The element that it stands for: itself, or the one that its attribute {@code reference} leads
   * to. Paths are relative to the element that has the attribute; {@code [2]} means the second
   * element of a name.
   *
   * @return empty if the path leads nowhere
   * @throws UnreadableFile if references lead in a circle
   */
  public Optional<XmlElement> resolved() throws UnreadableFile {
    Set<XmlElement> passed = new HashSet<>();
    XmlElement at = this;
    while (true) {
      Optional<String> path = at.attribute(REFERENCE);
      if (path.isEmpty()) {
        return Optional.of(at);
      }
      if (passed.size() == MAX_STEPS) {
        throw wrong(PolyscopeXmlTexts.text("longReference", MAX_STEPS));
      }
      if (!passed.add(at)) {
        throw wrong(PolyscopeXmlTexts.text("circularReference", text(REFERENCE), at.path()));
      }
      Optional<XmlElement> next = at.follow(path.get());
      if (next.isEmpty()) {
        return Optional.empty();
      }
      at = next.get();
    }
  }

  private Optional<XmlElement> follow(String path) {
    XmlElement at = this;
    String rest = path;
    if (rest.startsWith("/")) {
      while (at.parent != null) {
        at = at.parent;
      }
      int slash = rest.indexOf('/', 1);
      if (!rest.substring(1, slash < 0 ? rest.length() : slash).equals(at.name)) {
        return Optional.empty();
      }
      rest = slash < 0 ? "" : rest.substring(slash + 1);
    }
    for (String step : rest.isEmpty() ? List.<String>of() : List.of(rest.split("/", -1))) {
      at = step.equals("..") ? at.parent : step.equals(".") ? at : at.numbered(step);
      if (at == null) {
        return Optional.empty();
      }
    }
    at.see();
    return Optional.of(at);
  }

  /** The child that a step of a path means; null if there is none. */
  private XmlElement numbered(String step) {
    int bracket = step.indexOf('[');
    String wanted = bracket < 0 ? step : step.substring(0, bracket);
    int number = bracket < 0 ? 1 : number(step.substring(bracket));
    List<XmlElement> alike = alike(wanted);
    return number > 0 && number <= alike.size() ? alike.get(number - 1) : null;
  }

  private static int number(String brackets) {
    boolean right = brackets.matches("\\[[0-9]{1,7}\\]");
    return right ? Integer.parseInt(brackets.substring(1, brackets.length() - 1)) : 0;
  }

  private void see() {
    seen = true;
  }

  /** Says that all of it is understood, or need not be. */
  public void seeAll() {
    seen = true;
    read = new HashSet<>(attributeNames());
    children.forEach(XmlElement::seeAll);
  }

  /** Hands over this element and all in it, each before what is in it. */
  public void forEach(Consumer<XmlElement> action) {
    action.accept(this);
    children.forEach(each -> each.forEach(action));
  }

  /** The attributes and elements in it that were not asked for. */
  public List<String> unread() {
    List<String> unread = new ArrayList<>();
    for (int i = 0; i < attributes.length; i += 2) {
      if (!read.contains(attributes[i])) {
        unread.add(attributes[i] + "=\"" + attributes[i + 1] + "\"");
      }
    }
    children.stream().filter(each -> !each.seen).forEach(each -> unread.add("<" + each.name + ">"));
    return unread;
  }
}
