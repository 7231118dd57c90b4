package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.installation.Installation;
import org.pendant.project.polyscope.xml.PackedXml;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.polyscope.xml.XmlText;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Section.InitialValue;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.text.ProgramText;

/**
 * Program writer: makes the elements of a tree. What was written is read again at once: a node that
 * does not come back as it was is written in a form of our own, with its text in it, so that
 * nothing is lost.
 */
final class UrpProgramWriter {
  private static final String VERSION = "5.24.1";
  private static final String CHILDREN = "children";
  private static final int MAX_TURNS = 4;

  /** Sub programs that call others further down stand beside the main program. */
  private static final int DEEPEST_CALL = 300;

  private final String name;
  private final ProgramTree tree;
  private final Installation installation;

  /** Keys of nodes that have no other form than ours. */
  private final Set<Long> own = new HashSet<>();

  private final Map<String, WaypointPosition> ownPlaces = new LinkedHashMap<>();
  private boolean ownHeader;
  private XmlText out = new XmlText();
  private StepElements elements = new StepElements(out);
  private MotionElements motion;

  UrpProgramWriter(String name, ProgramTree tree, Installation installation) {
    this.name = name;
    this.tree = tree.renumbered();
    this.installation = installation;
    motion = new MotionElements(out, elements, this.tree.waypoints(), installation);
  }

  /** The text of the file, uncompressed. */
  String write() {
    for (int turn = 1; turn < MAX_TURNS; turn++) {
      String text = attempt();
      if (complete(text)) {
        return text;
      }
    }
    return attempt();
  }

  /** Nodes in our own form, after {@link #write}. */
  List<String> ownForms() {
    List<ProgramNode> all = tree.nodes();
    List<String> forms = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      if (own.contains(all.get(i).key())) {
        forms.add(text("ownNode", i + 1, NodeKind.of(all.get(i).step()).title()));
      }
    }
    return forms;
  }

  private boolean complete(String text) {
    ProgramTree read;
    try {
      read = new UrpProgramReader(PackedXml.read(text), installation).read(name).tree();
    } catch (UnreadableFile e) {
      throw new IllegalStateException("what was just written can be read: " + e.report(name), e);
    }
    boolean same = compare(tree.sections(), read.sections());
    for (Map.Entry<String, WaypointPosition> each : tree.waypoints().entrySet()) {
      if (!each.getValue().equals(read.waypoints().get(each.getKey()))) {
        ownPlaces.put(each.getKey(), each.getValue());
      }
    }
    boolean header = !ownPlaces.isEmpty() || !read.installation().equals(tree.installation());
    same &= ownHeader || !header;
    ownHeader |= header;
    return same;
  }

  private boolean compare(List<ProgramNode> written, List<ProgramNode> read) {
    boolean same = true;
    for (int i = 0; i < written.size(); i++) {
      ProgramNode node = written.get(i);
      if (written.size() != read.size() || !alike(node, read.get(i))) {
        // what is in our form already cannot get any better
        same &= !own.add(node.key());
      } else {
        same &= compare(node.children(), read.get(i).children());
      }
    }
    return same;
  }

  /** PolyScope wants a name in any case. */
  private static String installationName(String file) {
    int dot = file.lastIndexOf('.');
    return file.isEmpty() ? "default" : dot > 0 ? file.substring(0, dot) : file;
  }

  private static boolean alike(ProgramNode node, ProgramNode read) {
    return node.step().equals(read.step()) && node.suppressed() == read.suppressed();
  }

  private String attempt() {
    out = new XmlText();
    elements = new StepElements(out);
    motion = new MotionElements(out, elements, tree.waypoints(), installation);
    String file = installationName(tree.installation());
    out.open(
        UrpProgramReader.ROOT,
        "name",
        name,
        "installation",
        file,
        "installationRelativePath",
        file,
        "directory",
        "/programs",
        "createdIn",
        VERSION,
        "lastSavedIn",
        VERSION,
        "robotSerialNumber",
        "");
    motion.kinematics("kinematics");
    out.open(CHILDREN);
    tree.sections().forEach(this::section);
    out.close();
    if (ownHeader) {
      ProgramTree header = new ProgramTree(tree.installation(), ownPlaces, List.of(), 1);
      out.open(UrpProgramReader.OWN_PROGRAM).text("text", ProgramText.write(header)).close();
    }
    out.close();
    return "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n" + out;
  }

  private void section(ProgramNode node) {
    boolean off = node.suppressed() && !(node.step() instanceof Section.InitialValues);
    if (own.contains(node.key()) || !(node.step() instanceof Section part)) {
      ownNode(node, Within.NOTHING);
      return;
    }
    if (off) {
      out.open(SwitchedOff.WRAPPER).role(SwitchedOff.NAME);
    }
    if (openSection(part)) {
      children(node, Within.NOTHING);
      out.close();
    }
    if (off) {
      out.close();
    }
  }

  /** Begins a part of the program; answers whether it stands here and not elsewhere. */
  private boolean openSection(Section part) {
    switch (part) {
      case Section.InitialValues values -> {
        out.open(UrpProgramReader.INITIAL_VALUES);
        out.open("variables");
        values.values().forEach(this::initialValue);
        out.close();
      }
      case Section.BeforeStart _ -> out.open("SpecialSequence", "type", "BeforeStart");
      case Section.MainProgram main -> {
        boolean initial =
            tree.sections().stream()
                .anyMatch(
                    each -> each.step() instanceof Section.InitialValues && !each.suppressed());
        out.open("MainProgram", "runOnlyOnce", Boolean.toString(!main.forever()));
        out.attribute(UrpProgramReader.INITIAL_VALUES, Boolean.toString(initial));
      }
      case Section.ThreadSection thread ->
          out.open("Thread", "name", thread.name(), "loop", Boolean.toString(thread.forever()));
      case Section.Event event -> {
        out.open("Event");
        elements.expression("expression", event.condition());
      }
      case Section.SubProgram sub -> {
        if (!out.first("SubProgram", subKey(sub.name()))) {
          return false;
        }
        openSub("SubProgram", sub);
      }
    }
    return true;
  }

  private void initialValue(InitialValue value) {
    out.open("variable", "name", value.variable());
    elements.expression("expression", value.expression());
    out.close();
  }

  private static String subKey(String subName) {
    return "sub program " + subName;
  }

  private void openSub(String element, Section.SubProgram sub) {
    out.open(element, "name", sub.name(), "keepHidden", "false");
    out.attribute("keepSynchronizedWithDisk", Boolean.toString(!sub.file().isEmpty()));
    out.attribute("trackProgramExecution", "true");
    if (!sub.file().isEmpty()) {
      out.text("programFile", sub.file(), "resolves-to", "file");
    }
  }

  private void children(ProgramNode node, Within within) {
    if (!node.children().isEmpty()) {
      out.open(CHILDREN);
      node.children().forEach(each -> node(each, within));
      out.close();
    }
  }

  private void node(ProgramNode node, Within within) {
    if (own.contains(node.key())) {
      ownNode(node, within);
      return;
    }
    if (node.suppressed()) {
      out.open(SwitchedOff.WRAPPER).role(SwitchedOff.NAME);
    }
    plain(node, within);
    if (node.suppressed()) {
      out.close();
    }
  }

  private void plain(ProgramNode node, Within within) {
    if (node.step() instanceof ForeignStep foreign && foreign(foreign, node.suppressed())) {
      return;
    }
    boolean known =
        switch (node.step()) {
          case ActionStep.Call call -> call(call);
          case ActionStep action -> elements.open(action);
          case FlowStep flow -> {
            elements.open(flow);
            yield true;
          }
          case MotionStep step -> motion.open(step, within);
          case TemplateStep.Force force -> ForceNodes.open(force, out);
          case ForeignStep _, TemplateStep _, Section _ -> false;
        };
    if (!known) {
      own.add(node.key());
      out.role("");
      ownNode(node.withSuppressed(false), within);
      return;
    }
    children(node, inside(node, within));
    out.close();
  }

  private static Within inside(ProgramNode node, Within around) {
    return switch (node.step()) {
      case MotionStep.Move move -> MotionElements.inside(move);
      case MotionStep.CircleMove _ -> around.without();
      case ActionStep _, FlowStep _, ForeignStep _, MotionStep _, TemplateStep _, Section _ ->
          around;
    };
  }

  /** A node as text, for which no element is known; what is below it stands in it as usual. */
  private void ownNode(ProgramNode node, Within within) {
    out.open(UrpProgramReader.OWN_NODE);
    out.text("text", ProgramText.writeClip(List.of(node.withChildren(List.of())), Map.of()));
    children(node, inside(node, within));
    out.close();
  }

  /** A sub program stands in full where it is called first. */
  private boolean call(ActionStep.Call call) {
    Optional<ProgramNode> section =
        tree.sections().stream()
            .filter(
                each ->
                    each.step() instanceof Section.SubProgram sub
                        && sub.name().equals(call.subProgram())
                        && !each.suppressed()
                        && !own.contains(each.key()))
            .findFirst();
    out.open("CallSubProgram");
    if (section.isEmpty() || out.depth() > DEEPEST_CALL) {
      out.leaf("subprogram", "referencedName", call.subProgram());
    } else if (out.first("subprogram", subKey(call.subProgram()))) {
      openSub("subprogram", (Section.SubProgram) section.get().step());
      children(section.get(), Within.NOTHING);
      out.close();
    }
    return true;
  }

  /** Writes an element as it was; answers whether it still is one. */
  private boolean foreign(ForeignStep step, boolean suppressed) {
    return switch (step) {
      case ForeignStep.Unknown unknown -> raw(unknown.data(), suppressed);
      case ForeignStep.Contributed contributed -> {
        if (!contributed.stub().isEmpty() && whole(contributed.data()).isPresent()) {
          byte[] stub = String.join("\n", contributed.stub()).getBytes(StandardCharsets.UTF_8);
          out.comment(PreservedElements.STUB + Base64.getEncoder().encodeToString(stub));
        }
        yield raw(contributed.data(), suppressed);
      }
    };
  }

  private boolean raw(List<String> data, boolean suppressed) {
    Optional<XmlElement> element = whole(data);
    element.ifPresent(
        each -> {
          out.role("");
          out.raw(each.name(), suppressed ? SwitchedOff.written(each) : each.raw());
        });
    return element.isPresent();
  }

  /** The one element that lines of text are, if they are one. */
  private static Optional<XmlElement> whole(List<String> data) {
    String text = String.join("\n", data);
    try {
      XmlElement element = PackedXml.read(text);
      return element.raw().equals(text) ? Optional.of(element) : Optional.empty();
    } catch (UnreadableFile e) {
      // it has been changed; it is kept as text
      return Optional.empty();
    }
  }
}
