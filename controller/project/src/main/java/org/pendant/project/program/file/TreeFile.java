package org.pendant.project.program.file;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.check.NodeProblem;
import org.pendant.project.program.check.ProgramCheck;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.ReadProgram;
import org.pendant.project.program.urp.ImportedProgram;
import org.pendant.project.program.urp.ShownNodes;
import org.pendant.project.program.urp.UrpPrograms;
import org.pendant.project.program.urp.UrpxPrograms;

/**
 * Tree file: a file with a program tree, together with the installation that it runs in. Immutable;
 * reads nothing itself.
 */
public final class TreeFile {
  /** Endings of such files that can be written as well. */
  public static final List<String> ENDINGS = List.of(ProgramText.ENDING, UrpPrograms.ENDING);

  /** Ending that the generated script gets after the name of the file. */
  public static final String SCRIPT = ".script";

  private final String name;
  private final byte[] bytes;
  private final ProgramTree tree;
  private final Installation installation;
  private final Optional<String> robot;
  private final List<String> remarks;

  /** The line of each node in the file, from 1, by key; empty when lines mean nothing to people. */
  private final Map<Long, Integer> lines;

  private final Optional<ControlScript> control;

  private TreeFile(
      String name,
      byte[] bytes,
      ProgramTree tree,
      Installation installation,
      Optional<String> robot,
      List<String> remarks,
      Map<Long, Integer> lines,
      Optional<ControlScript> control) {
    this.name = name;
    this.bytes = bytes;
    this.tree = tree;
    this.installation = installation;
    this.robot = robot;
    this.remarks = List.copyOf(remarks);
    this.lines = Map.copyOf(lines);
    this.control = control;
  }

  /** Whether a file of this name should hold a program tree. */
  public static boolean hasEnding(String name) {
    return isForeign(name) || isWritable(name);
  }

  /** Whether a file of this name holds a program of PolyScope X, which is read and not written. */
  public static boolean isForeign(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(UrpxPrograms.ENDING);
  }

  /** Whether a tree can be written to a file of this name. */
  public static boolean isWritable(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return ENDINGS.stream().anyMatch(lower::endsWith);
  }

  /**
   * Understands a file, with nothing set up.
   *
   * @param name of the file; its ending tells the form
   * @throws BrokenTree if that cannot be
   */
  public static TreeFile read(String name, byte[] bytes) throws BrokenTree {
    return read(name, bytes, Installation.NONE);
  }

  private static TreeFile read(String name, byte[] bytes, Installation installation)
      throws BrokenTree {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(UrpPrograms.ENDING) || isForeign(name)
        ? imported(name, bytes, installation)
        : text(name, bytes, installation);
  }

  private static TreeFile imported(String name, byte[] bytes, Installation installation)
      throws BrokenTree {
    try {
      ImportedProgram read =
          isForeign(name)
              ? UrpxPrograms.read(lastPart(name), bytes)
              : UrpPrograms.read(lastPart(name), bytes, installation);
      return new TreeFile(
          name,
          bytes,
          read.tree(),
          withTools(withFeatures(installation, read.features()), read.tools()),
          read.robot(),
          read.remarks(),
          Map.of(),
          Optional.empty());
    } catch (UnreadableFile e) {
      throw new BrokenTree(List.of(e.report(name)));
    }
  }

  /** What programs tell of features counts where the installation knows nothing of them. */
  private static Installation withFeatures(Installation installation, List<Feature> told) {
    List<Feature> all = new ArrayList<>(installation.features());
    told.stream().filter(each -> installation.feature(each.name()).isEmpty()).forEach(all::add);
    return all.size() == installation.features().size()
        ? installation
        : installation.withFeatures(all);
  }

  /** The same of TCPs. */
  private static Installation withTools(Installation installation, List<NamedTool> told) {
    List<NamedTool> all = new ArrayList<>(installation.tools());
    told.stream().filter(each -> installation.tool(each.name()).isEmpty()).forEach(all::add);
    return all.size() == installation.tools().size() ? installation : installation.withTools(all);
  }

  private static TreeFile text(String name, byte[] bytes, Installation installation)
      throws BrokenTree {
    String text;
    try {
      text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
    } catch (CharacterCodingException e) {
      throw new BrokenTree(List.of(ProgramFileTexts.text("noText", name)));
    }
    ReadProgram read = ProgramText.read(text);
    if (!read.problems().isEmpty()) {
      throw new BrokenTree(
          read.problems().stream()
              .map(
                  each ->
                      place(name, each.line()) + ":" + each.column() + ": error: " + each.message())
              .toList());
    }
    return new TreeFile(
        name,
        bytes,
        read.tree(),
        installation,
        Optional.empty(),
        List.of(),
        lines(text, read.tree()),
        Optional.empty());
  }

  /** A node a line, apart from what stands at the top and lines of text that belong to a node. */
  private static Map<Long, Integer> lines(String text, ProgramTree tree) {
    List<String> all = text.lines().toList();
    List<Integer> nodeLines =
        IntStream.range(1, all.size())
            .filter(i -> isNode(all.get(i)))
            .mapToObj(i -> i + 1)
            .toList();
    List<ProgramNode> nodes = tree.nodes();
    return IntStream.range(0, Math.min(nodes.size(), nodeLines.size()))
        .boxed()
        .collect(Collectors.toMap(i -> nodes.get(i).key(), nodeLines::get));
  }

  private static boolean isNode(String line) {
    String content = line.strip();
    boolean header = line.startsWith("position ") || line.startsWith("installation ");
    return !content.isEmpty() && !header && "|>-".indexOf(content.charAt(0)) < 0;
  }

  /**
   * How many nodes of it wait for a script that the installation's {@link
   * Installation#controlHost()} must be asked for before the program can start.
   */
  public int waitingNodes() {
    return control.isPresent() ? 0 : ExternalControl.count(tree);
  }

  /** The same program, with the script that its External Control nodes wait for. */
  public TreeFile with(ControlScript sent) {
    return new TreeFile(name, bytes, tree, installation, robot, remarks, lines, Optional.of(sent));
  }

  /** The same program in another installation; waits for a script again. */
  public TreeFile in(Installation other) {
    try {
      return read(name, bytes, other);
    } catch (BrokenTree e) {
      throw new IllegalStateException("what was read once can be read again", e);
    }
  }

  /** Its name, as it was given. */
  public String name() {
    return name;
  }

  /** The line of each node, from 1, by key; empty where lines mean nothing to people. */
  public Map<Long, Integer> nodeLines() {
    return lines;
  }

  /** Its text; empty where lines mean nothing to people. */
  public String content() {
    return lines.isEmpty() ? "" : new String(bytes, StandardCharsets.UTF_8);
  }

  /** The program. */
  public ProgramTree tree() {
    return tree;
  }

  /** What it runs in; has the features, too, that the program itself tells of. */
  public Installation installation() {
    return installation;
  }

  /** Id of the arm that the program was made on, if the file tells. */
  public Optional<String> robot() {
    return robot;
  }

  /** What was not understood; the program can run all the same. */
  public List<String> remarks() {
    return remarks.stream().map(each -> ProgramFileTexts.text("note", name, each)).toList();
  }

  /** Whether there are nodes that do nothing because it is not said what they should do. */
  public boolean hasGaps() {
    boolean[] gaps = {false};
    tree.sections().forEach(each -> gaps[0] |= gap(each));
    return gaps[0];
  }

  private static boolean gap(ProgramNode node) {
    if (node.suppressed()) {
      return false;
    }
    boolean own =
        node.step() instanceof ForeignStep.Unknown
            || (node.step() instanceof ForeignStep.Contributed contributed
                && contributed.stub().isEmpty()
                && !ExternalControl.is(contributed));
    return own || node.children().stream().anyMatch(TreeFile::gap);
  }

  /** What keeps the program from running, each with the line of its node. */
  public List<String> problems() {
    return ProgramCheck.problems(tree, installation).stream()
        .filter(NodeProblem::blocks)
        .map(this::report)
        .toList();
  }

  private String report(NodeProblem problem) {
    String field = problem.field().isEmpty() ? "" : problem.field() + ": ";
    return place(name, lineOf(problem.key())) + ": error: " + field + problem.message();
  }

  /** The line of a node; its number in the tree where the file has no lines for people. */
  private int lineOf(long key) {
    int number = numberOf(key);
    return lines.getOrDefault(key, number);
  }

  private int numberOf(long key) {
    List<ProgramNode> nodes = tree.nodes();
    return IntStream.range(0, nodes.size())
            .filter(i -> nodes.get(i).key() == key)
            .findFirst()
            .orElse(0)
        + 1;
  }

  private static String place(String file, int line) {
    return file + ":" + line;
  }

  /** The script that it runs as, generated anew each time. */
  public GeneratedScript script() {
    GeneratedScript script = ScriptGenerator.generate(programName(), tree, installation, control);
    return isForeign(name) ? ShownNodes.placed(tree, script) : script;
  }

  /** What the generated script is called in messages. */
  public String scriptName() {
    return name + SCRIPT;
  }

  /** The node that a line of the script belongs to, such as {@code node 12 "Waypoint_3"}. */
  public Optional<String> nodeAt(int line) {
    return script()
        .at(line)
        .flatMap(place -> tree.find(place.key()).map(node -> text(place.number(), node)));
  }

  /**
   * Which line of what a driver has sent a line of the script is, in words.
   *
   * @param script {@link #script()}
   */
  public Optional<String> receivedAt(GeneratedScript script, int line) {
    OptionalInt number = script.receivedLine(line);
    return number.isPresent()
        ? control.map(each -> each.place(number.getAsInt()))
        : Optional.empty();
  }

  private static String text(int number, ProgramNode node) {
    return ProgramFileTexts.text("node", number, StepNames.label(node));
  }

  /** The name of the program: that of the file, without folders and ending. */
  public String programName() {
    String last = lastPart(name);
    int dot = last.lastIndexOf('.');
    return dot > 0 ? last.substring(0, dot) : last;
  }

  private static String lastPart(String path) {
    return path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
  }
}
