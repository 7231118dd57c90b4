package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.signature.Signature;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.json.JsonFactory;

/**
 * Program files of PolyScope X: reads {@code .urpx} files, which contain a program with all that
 * belongs to it. Its nodes are those of web pages, each with a form of its own; what they do stands
 * beside them as a script. That runs; the nodes are shown, suppressed. So is what sets up the
 * robot, if it needs functions that only PolyScope X has.
 */
public final class UrpxPrograms {
  /** Ending of the names of such files. */
  public static final String ENDING = ".urpx";

  /** The remark on every such program. */
  public static final String ONLY_SHOWN = text("onlyShown");

  /** A line that says at which node the script is: its number among those with lines. */
  private static final Pattern LABEL = Pattern.compile("^(\\s*)\\$ (\\d{1,9}) (.*)");

  /** Texts and remarks. */
  private static final Pattern REST = Pattern.compile("\"[^\"]*\"|#.*");

  private static final Pattern DEFINED = Pattern.compile("^(?:def|thread)\\s+(\\w+)");
  private static final Pattern CALLED = Pattern.compile("(?<![.\\w])([A-Za-z_]\\w*)\\s*\\(");

  /** Words of the language that a bracket may follow. */
  private static final Set<String> WORDS =
      Set.of("if", "elif", "while", "and", "or", "xor", "not", "return", "struct");

  /** The numbers of nodes in the tree, by their ids. */
  private final Map<String, Integer> numbers = new HashMap<>();

  /** How many nodes the tree has so far; the main program is the first. */
  private int count = 1;

  private UrpxPrograms() {}

  /**
   * Reads a program.
   *
   * @param fileName without folders
   * @throws UnreadableFile if it is no program, or was saved without its script
   */
  public static ImportedProgram read(String fileName, byte[] bytes) throws UnreadableFile {
    return new UrpxPrograms().program(fileName, object(parsed(bytes), "fileMissing", ""));
  }

  /**
   * The name that PolyScope X has for a program, whatever its file is called.
   *
   * @throws UnreadableFile if it is no program, was saved without its script, or says no name
   */
  public static String nameIn(byte[] bytes) throws UnreadableFile {
    Map<?, ?> file = object(parsed(bytes), "fileMissing", "");
    var _ = new UrpxPrograms().program("", file);
    if (member(member(file, "program"), "programInformation").get("name") instanceof String name) {
      return name;
    }
    throw new UnreadableFile(0, 0, text("programWithoutName"));
  }

  private ImportedProgram program(String fileName, Map<?, ?> file) throws UnreadableFile {
    Map<?, ?> program = member(file, "program");
    Map<?, ?> application = member(file, "application");
    List<String> remarks = new ArrayList<>();
    remarks.add(ONLY_SHOWN);
    List<String> setUp = script(application);
    List<String> missing = missing(setUp);
    if (!missing.isEmpty()) {
      remarks.add(text("setUpSuppressed", String.join(", ", missing)));
    }
    ProgramNode nodes = node(member(program, "programContent"), 1).withSuppressed(true);
    List<ProgramNode> all = new ArrayList<>(List.of(nodes));
    node(fileName, setUp).map(node -> node.withSuppressed(!missing.isEmpty())).ifPresent(all::add);
    node(fileName, script(program)).ifPresent(all::add);
    ProgramTree tree =
        new ProgramTree("", Map.of(), List.of(), 1)
            .insert(
                ProgramTree.ROOT,
                0,
                List.of(
                    ProgramTree.node(
                        new Section.MainProgram(false), all.toArray(ProgramNode[]::new))));
    String name =
        fileName.endsWith(ENDING)
            ? fileName.substring(0, fileName.length() - ENDING.length())
            : fileName;
    return new ImportedProgram(name, tree, List.of(), List.of(), Optional.empty(), remarks);
  }

  /** A node that runs a script; empty if there is nothing in it. */
  private static Optional<ProgramNode> node(String fileName, List<String> script) {
    return script.stream().allMatch(String::isBlank)
        ? Optional.empty()
        : Optional.of(ProgramTree.node(new ActionStep.ScriptFile(fileName, script)));
  }

  /** Functions that a script calls and that are neither in it nor in the language. */
  private static List<String> missing(List<String> script) {
    Set<String> known =
        StandardBuiltins.create().all().stream()
            .map(Signature::name)
            .collect(Collectors.toCollection(HashSet::new));
    known.addAll(WORDS);
    List<String> code =
        script.stream().map(line -> REST.matcher(line).replaceAll("")).map(String::strip).toList();
    code.forEach(line -> DEFINED.matcher(line).results().forEach(each -> known.add(each.group(1))));
    return code.stream()
        .flatMap(line -> CALLED.matcher(line).results().map(each -> each.group(1)))
        .filter(name -> !known.contains(name))
        .distinct()
        .sorted()
        .toList();
  }

  private static Object parsed(byte[] bytes) throws UnreadableFile {
    try (JsonParser parser = new JsonFactory().createParser(ObjectReadContext.empty(), bytes)) {
      parser.nextToken();
      return value(parser);
    } catch (JacksonException e) {
      TokenStreamLocation at = e.getLocation();
      String why = text("noJson", e.getOriginalMessage());
      throw at == null
          ? new UnreadableFile(0, 0, why)
          : new UnreadableFile(at.getLineNr(), at.getColumnNr(), why);
    }
  }

  /** Objects as maps, arrays as lists, all else as text. */
  private static Object value(JsonParser parser) {
    if (parser.currentToken() == JsonToken.START_OBJECT) {
      Map<String, Object> members = new LinkedHashMap<>();
      while (parser.nextToken() != JsonToken.END_OBJECT) {
        String name = parser.currentName();
        parser.nextToken();
        members.put(name, value(parser));
      }
      return members;
    }
    if (parser.currentToken() == JsonToken.START_ARRAY) {
      List<Object> elements = new ArrayList<>();
      while (parser.nextToken() != JsonToken.END_ARRAY) {
        elements.add(value(parser));
      }
      return elements;
    }
    return parser.hasCurrentToken() ? parser.getString() : "";
  }

  /**
   * An object.
   *
   * @param key of the text that says that it is missing
   * @param name that goes into it
   */
  private static Map<?, ?> object(Object value, String key, String name) throws UnreadableFile {
    if (value instanceof Map<?, ?> members) {
      return members;
    }
    throw new UnreadableFile(0, 0, text(key, name));
  }

  private static Map<?, ?> member(Map<?, ?> of, String name) throws UnreadableFile {
    return object(of.get(name), "memberMissing", name);
  }

  /**
   * Lines of the script of a part. Labels in it count nodes otherwise than the tree does; they
   * become remarks, with the number of the node in the tree where the file says which node it is.
   */
  private List<String> script(Map<?, ?> part) throws UnreadableFile {
    Map<?, ?> script = member(part, "urscript");
    if (!(script.get("script") instanceof String text)) {
      throw new UnreadableFile(0, 0, text("scriptMissing"));
    }
    List<?> ids = script.get("nodeIDList") instanceof List<?> all ? all : List.of();
    return text.lines().map(line -> remark(line, ids)).toList();
  }

  private String remark(String line, List<?> ids) {
    Matcher label = LABEL.matcher(line);
    if (!label.matches()) {
      return line;
    }
    int index = Integer.parseInt(label.group(2));
    Integer number = index < ids.size() ? numbers.get(ids.get(index)) : null;
    return label.group(1)
        + (number == null
            ? "# " + index + " " + label.group(3)
            : ShownNodes.remark(number, label.group(3)));
  }

  private ProgramNode node(Map<?, ?> node, int depth) throws UnreadableFile {
    if (depth > ProgramTree.DEEPEST - 1) {
      throw new UnreadableFile(0, 0, text("tooDeep", ProgramTree.DEEPEST));
    }
    count++;
    if (node.get("guid") instanceof String id) {
      numbers.putIfAbsent(id, count);
    }
    String type =
        node.get("contributedNode") instanceof Map<?, ?> contributed
                && contributed.get("type") instanceof String text
            ? text
            : "node";
    List<ProgramNode> children = new ArrayList<>();
    if (node.get("children") instanceof List<?> all) {
      for (Object each : all) {
        children.add(node(object(each, "childMissing", type), depth + 1));
      }
    }
    return ProgramTree.node(
        new ActionStep.Folder((type + " " + label(node)).strip()),
        children.toArray(ProgramNode[]::new));
  }

  /** What is shown beside a node. */
  private static String label(Map<?, ?> node) {
    StringBuilder label = new StringBuilder();
    if (node.get("programLabel") instanceof List<?> parts) {
      for (Object part : parts) {
        if (part instanceof Map<?, ?> members && members.get("value") instanceof String text) {
          label.append(label.isEmpty() ? "" : " ").append(text);
        }
      }
    }
    return label.toString();
  }
}
