package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.ArmDescription;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Section.InitialValue;
import org.pendant.project.program.Step;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.text.Clip;
import org.pendant.project.program.text.ProgramText;

/** Program reader: makes a tree of the elements of one file. */
final class UrpProgramReader {
  static final String ROOT = "URProgram";

  /** Holds a node of ours, as text, for which no element is known. */
  static final String OWN_NODE = "pendant.Node";

  /** Holds places that no waypoint in the file has, and the installation, as text. */
  static final String OWN_PROGRAM = "pendant.Program";

  static final String INITIAL_VALUES = "InitVariablesNode";

  private static final String CHILDREN = "children";

  /** Stands around what is switched off. */
  private static final int MAX_NODES = 200_000;

  /** Older files keep the last chosen move in the main program, which means nothing. */
  private static final List<String> OLD_MOVE =
      List.of("motionType", "speed", "acceleration", "useActiveTCP", "positionType");

  private final XmlElement root;

  /** The arm that the program should be for. */
  private final ArmDescription expected;

  private final Remarks remarks = new Remarks();
  private final ExpressionReader expressions;
  private final MotionReader motion;
  private final ActionReader action;
  private final FlowReader flow;
  private final Positions positions;

  /** Elements whose attributes and children were all to be understood. */
  private final List<XmlElement> understood = new ArrayList<>();

  private final List<ProgramNode> stray = new ArrayList<>();
  private final Set<XmlElement> subPrograms = new HashSet<>();
  private final Set<String> subProgramNames = new HashSet<>();
  private int nodeCount;

  /** Whether a suppressed node is read: what is not understood there is of no consequence. */
  private boolean switchedOff;

  UrpProgramReader(XmlElement root, Installation installation) {
    this.root = root;
    expected = Arms.of(installation.robot());
    UrpSignals signals = new UrpSignals(installation, remarks);
    expressions = new ExpressionReader(signals, remarks);
    positions = new Positions(root.child("kinematics"), expected, remarks);
    motion = new MotionReader(expressions, signals, positions, remarks);
    action = new ActionReader(expressions, signals);
    flow = new FlowReader(expressions);
  }

  ImportedProgram read(String fileName) throws UnreadableFile {
    understood.add(root);
    List<ProgramNode> sections = new ArrayList<>();
    Optional<XmlElement> top = root.child(CHILDREN);
    for (XmlElement each : top.isEmpty() ? List.<XmlElement>of() : top.get().children()) {
      if (each.name().equals(SwitchedOff.WRAPPER)) {
        understood.add(each);
        switchedOff = true;
        for (XmlElement inside : each.children()) {
          section(inside).map(node -> node.withSuppressed(true)).ifPresent(sections::add);
        }
        switchedOff = false;
      } else {
        section(each).ifPresent(sections::add);
      }
    }
    sections.addAll(inlineSubPrograms());
    List<ProgramNode> whole = withStray(sections);
    Map<String, WaypointPosition> places = new LinkedHashMap<>(positions.all());
    String installationName = installationName();
    Optional<XmlElement> own = root.child(OWN_PROGRAM).flatMap(each -> each.child("text"));
    if (own.isPresent()) {
      ProgramTree header = ProgramText.read(own.get().text()).tree();
      installationName = header.installation();
      places.putAll(header.waypoints());
    }
    ProgramTree tree =
        new ProgramTree(installationName, places, List.of(), 1).insert(ProgramTree.ROOT, 0, whole);
    String base =
        fileName.endsWith(UrpPrograms.ENDING)
            ? fileName.substring(0, fileName.length() - UrpPrograms.ENDING.length())
            : fileName;
    String name = root.attribute("name").orElse(base);
    Unread.tell(understood, remarks);
    return new ImportedProgram(
        name, tree, positions.features(), positions.tools(), robot(), remarks.all());
  }

  /** The arm that the program was made on; told where another one is expected. */
  private Optional<String> robot() {
    Optional<ArmDescription> arm =
        root.child("kinematics").flatMap(each -> Arms.described(each, expected));
    Optional<String> model = arm.flatMap(each -> Arms.model(each, expected));
    if (arm.isPresent() && model.isEmpty()) {
      remarks.add(root, text("armUnknown"));
    }
    model
        .filter(each -> !each.equals(expected.id()))
        .ifPresent(each -> remarks.add(root, text("madeOn", each)));
    return model;
  }

  /** The installation, without an ending; a path says more than a name. */
  private String installationName() {
    String said = root.text("installation");
    String path = root.attribute("installationRelativePath").orElse("");
    return path.isEmpty() || said.isEmpty() ? said : path;
  }

  /** What stood beside the sections is kept at the end of the main program. */
  private List<ProgramNode> withStray(List<ProgramNode> sections) throws UnreadableFile {
    List<ProgramNode> all = new ArrayList<>();
    boolean main = false;
    for (ProgramNode each : sections) {
      if (each.step() instanceof Section.MainProgram && !main) {
        List<ProgramNode> children = new ArrayList<>(each.children());
        children.addAll(stray);
        all.add(each.withChildren(children));
        main = true;
      } else {
        all.add(each);
      }
    }
    if (!main) {
      throw root.wrong(text("noMain"));
    }
    return all;
  }

  private Optional<ProgramNode> section(XmlElement element) throws UnreadableFile {
    Optional<XmlElement> found = element.resolved();
    if (found.isEmpty()) {
      remarks.add(element, text("danglingReference", element.name()));
      return Optional.empty();
    }
    XmlElement target = found.get();
    if (element.name().equals(INITIAL_VALUES)) {
      return initialValues(target);
    }
    Optional<Clip> own =
        element.name().equals(OWN_NODE) ? clip(Optional.of(element)) : Optional.empty();
    Optional<Step> step =
        own.isPresent() ? only(own.get()) : sectionStep(SwitchedOff.kind(element), target);
    if (step.isEmpty() || !(step.get() instanceof Section)) {
      Optional<ProgramNode> node = node(target, Within.NOTHING, 1);
      node.ifPresent(
          each -> {
            remarks.add(element, text("keptInMain", element.name()));
            stray.add(each);
          });
      return Optional.empty();
    }
    understood.add(target);
    List<ProgramNode> children = nodes(target, Within.NOTHING, 1);
    boolean suppressed = own.isPresent() && own.get().nodes().getFirst().suppressed();
    return Optional.of(
        ProgramTree.node(step.get(), children.toArray(ProgramNode[]::new))
            .withSuppressed(suppressed));
  }

  private Optional<Step> sectionStep(String name, XmlElement element) throws UnreadableFile {
    return switch (name) {
      case "SpecialSequence" ->
          element.text("type").equals("BeforeStart")
              ? Optional.of(new Section.BeforeStart())
              : Optional.empty();
      case "MainProgram" -> Optional.of(main(element));
      case "Thread" -> Optional.of(thread(element));
      case "Event" -> Optional.of(new Section.Event(expressions.in(element)));
      case "SubProgram" -> Optional.of(subProgram(element));
      default -> Optional.empty();
    };
  }

  private Section.MainProgram main(XmlElement element) {
    var _ = element.child("feature");
    for (String each : OLD_MOVE) {
      var _ = element.attribute(each);
    }
    var _ = element.attribute(INITIAL_VALUES);
    return new Section.MainProgram(!Values.yes(element, "runOnlyOnce"));
  }

  private static Section.ThreadSection thread(XmlElement element) {
    boolean forever = true;
    for (String each : element.attributeNames()) {
      if (each.toLowerCase(Locale.ROOT).contains("loop")) {
        forever = Values.yes(element, each);
      } else if (each.equals("runOnlyOnce")) {
        forever = !Values.yes(element, each);
      }
    }
    return new Section.ThreadSection(element.text("name"), forever);
  }

  private Section.SubProgram subProgram(XmlElement element) {
    String file = element.child("programFile").map(XmlElement::text).orElse("").strip();
    element.child("programFile").ifPresent(XmlElement::seeAll);
    subPrograms.add(element);
    subProgramNames.add(element.text("name"));
    return new Section.SubProgram(element.text("name"), file);
  }

  /** Sub programs that stand nowhere but in the nodes that call them. */
  private List<ProgramNode> inlineSubPrograms() throws UnreadableFile {
    List<XmlElement> inline = new ArrayList<>();
    root.forEach(
        each -> {
          if (each.name().equals("subprogram") && each.attribute("name").isPresent()) {
            inline.add(each);
          }
        });
    List<ProgramNode> sections = new ArrayList<>();
    for (XmlElement each : inline) {
      if (!subPrograms.contains(each) && !subProgramNames.contains(each.text("name"))) {
        understood.add(each);
        Section.SubProgram step = subProgram(each);
        sections.add(
            ProgramTree.node(step, nodes(each, Within.NOTHING, 1).toArray(ProgramNode[]::new)));
      }
    }
    return sections;
  }

  /**
   * Initial values stand in a list of their own, those of older files at the variables, wherever
   * these are written in full. A program has a switch for them, and keeps them while it is off.
   */
  private Optional<ProgramNode> initialValues(XmlElement node) throws UnreadableFile {
    understood.add(node);
    List<InitialValue> values = new ArrayList<>();
    Set<String> named = new HashSet<>();
    Optional<XmlElement> listed = node.child("variables");
    for (XmlElement each : listed.map(list -> list.children("variable")).orElse(List.of())) {
      understood.add(each);
      values.add(new InitialValue(each.text("name"), expressions.in(each)));
      named.add(each.text("name"));
    }
    List<XmlElement> elsewhere = new ArrayList<>();
    root.forEach(
        each -> {
          if ((each.name().equals("variable") || each.name().equals("ProgramVariable"))
              && each.attribute("name").isPresent()) {
            elsewhere.add(each);
          }
        });
    for (XmlElement each : elsewhere) {
      String value = expressions.in(each, "initializeExpression");
      if (!value.isEmpty() && named.add(each.text("name"))) {
        values.add(new InitialValue(each.text("name"), value));
      }
    }
    boolean off = initialValuesOff();
    return off && values.isEmpty()
        ? Optional.empty()
        : Optional.of(ProgramTree.node(new Section.InitialValues(values)).withSuppressed(off));
  }

  private boolean initialValuesOff() {
    return root.child(CHILDREN)
        .flatMap(each -> each.child("MainProgram"))
        .flatMap(each -> each.attribute(INITIAL_VALUES))
        .orElse("true")
        .equals("false");
  }

  private List<ProgramNode> nodes(XmlElement parent, Within within, int depth)
      throws UnreadableFile {
    List<ProgramNode> nodes = new ArrayList<>();
    Optional<XmlElement> children = parent.child(CHILDREN);
    List<XmlElement> all = children.map(XmlElement::children).orElse(List.of());
    for (int i = 0; i < all.size(); i++) {
      XmlElement each = all.get(i);
      if (depth > ProgramTree.DEEPEST) {
        throw each.wrong(text("tooDeep", ProgramTree.DEEPEST));
      }
      Within here =
          i + 1 < all.size() ? within.before(MotionReader.isOtherMove(all.get(i + 1))) : within;
      if (each.name().equals(SwitchedOff.WRAPPER)) {
        nodes.addAll(suppressed(each, here, depth));
      } else {
        node(each, here, depth).ifPresent(nodes::add);
      }
    }
    return nodes;
  }

  private List<ProgramNode> suppressed(XmlElement wrapper, Within within, int depth)
      throws UnreadableFile {
    understood.add(wrapper);
    boolean around = switchedOff;
    switchedOff = true;
    List<ProgramNode> nodes = new ArrayList<>();
    for (XmlElement each : wrapper.children()) {
      if (each.name().equals(CHILDREN)) {
        nodes.addAll(nodes(wrapper, within, depth));
      } else {
        node(each, within, depth).ifPresent(nodes::add);
      }
    }
    switchedOff = around;
    return nodes.stream().map(each -> each.withSuppressed(true)).toList();
  }

  /** The node of an element; empty for a place where nodes may come. */
  private Optional<ProgramNode> node(XmlElement element, Within within, int depth)
      throws UnreadableFile {
    if (++nodeCount > MAX_NODES) {
      throw element.wrong(text("tooManyNodes", MAX_NODES));
    }
    if (element.name().equals("Placeholder")) {
      return Optional.empty();
    }
    if (element.name().equals(OWN_NODE)) {
      Optional<Clip> own = clip(Optional.of(element));
      if (own.isPresent() && own.get().nodes().size() == 1) {
        understood.add(element);
        ProgramNode node = own.get().nodes().getFirst();
        Within inside = motion.inside(element, node.step(), within);
        return Optional.of(node.withChildren(nodes(element, inside, depth + 1)));
      }
    }
    Remarks ofNode = switchedOff ? new Remarks() : remarks;
    if (SwitchedOff.kind(element).equals("Contributed")) {
      return Optional.of(ProgramTree.node(PreservedElements.contributed(element, ofNode)));
    }
    element.child("motionParameters").ifPresent(understood::add);
    Optional<Step> step = motion.step(element, within);
    step = step.isEmpty() ? action.step(element) : step;
    step = step.isEmpty() ? flow.step(element) : step;
    if (step.isEmpty()) {
      return Optional.of(ProgramTree.node(PreservedElements.unknown(element, ofNode)));
    }
    if (!switchedOff) {
      understood.add(element);
    }
    Within inside = motion.inside(element, step.get(), within);
    return Optional.of(
        ProgramTree.node(
            step.get(), nodes(element, inside, depth + 1).toArray(ProgramNode[]::new)));
  }

  private static Optional<Clip> clip(Optional<XmlElement> element) {
    Optional<XmlElement> text = element.flatMap(each -> each.child("text"));
    return text.flatMap(each -> ProgramText.readClip(each.text()));
  }

  private static Optional<Step> only(Clip clip) {
    return clip.nodes().size() == 1
        ? Optional.of(clip.nodes().getFirst().step())
        : Optional.empty();
  }
}
