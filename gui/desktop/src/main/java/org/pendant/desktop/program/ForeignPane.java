package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.CodeArea;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.GeneratedScript.NodeLines;
import org.pendant.project.program.urp.ShownNodes;

/**
 * Foreign program pane: what is known of a node of a program of PolyScope X: what it is called, and
 * its lines.
 */
@SuppressWarnings("serial") // never written to a stream
final class ForeignPane extends JPanel {
  private final JLabel heading = new JLabel();
  private final JTextArea about = new JTextArea();
  private final JTextArea lines = new CodeArea();
  private final JScrollPane scroll = new JScrollPane(lines);

  ForeignPane() {
    super(new MigLayout("insets 16, wrap, fill", "[grow, fill, 0::]", "[][][grow, fill]"));
    setName("program-foreign-node");
    heading.setName("program-foreign-name");
    heading.putClientProperty("FlatLaf.styleClass", "h3");
    about.setName("program-foreign-about");
    about.setEditable(false);
    about.setFocusable(false);
    about.setOpaque(false);
    about.setLineWrap(true);
    about.setWrapStyleWord(true);
    lines.setName("program-foreign-lines");
    lines.setEditable(false);
    lines.getAccessibleContext().setAccessibleName(text("scriptOfTheNode"));
    add(heading, "wmin 0");
    add(about, "wmin 0");
    add(scroll, "wmin 0, hmin 0");
    updateUI();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (about != null) {
      about.setFont(UIManager.getFont("Label.font"));
    }
  }

  /**
   * Shows a node.
   *
   * @param key of the one that was selected last
   */
  void show(TreeProgram program, OptionalLong key) {
    Optional<ProgramNode> node =
        key.isPresent() ? program.tree().find(key.getAsLong()) : Optional.empty();
    String code = node.map(each -> code(program.script(), each)).orElse("");
    heading.setText(
        node.map(each -> NodeLabels.shown(each.step())).orElse(text("nothingIsSelected")));
    about.setText(node.map(each -> about(program, each, code)).orElse(""));
    if (!lines.getText().equals(code)) {
      lines.setText(code);
      lines.setCaretPosition(0);
    }
    scroll.setVisible(!code.isEmpty());
    revalidate();
  }

  void focus() {
    lines.requestFocusInWindow();
  }

  private static String about(TreeProgram program, ProgramNode node, String code) {
    if (node.suppressed()) {
      return text("thisScriptIsSuppressedItDoes");
    }
    if (!ShownNodes.isShown(program.written(), node.key())) {
      return text("linesThatRunHere");
    }
    return code.isEmpty() ? text("polyscopeXNodeWithoutLines") : text("polyscopeXNodeWithLines");
  }

  /** The lines that a node has, moved as far left as they go. */
  private static String code(GeneratedScript script, ProgramNode node) {
    if (node.step() instanceof ActionStep.ScriptFile file && node.suppressed()) {
      return String.join("\n", file.lines());
    }
    Optional<NodeLines> place = script.of(node.key());
    List<String> found =
        place.isEmpty()
            ? List.of()
            : script
                .text()
                .lines()
                .skip(place.get().first() - 1L)
                .limit(place.get().last() - place.get().first() + 1L)
                .toList();
    int left =
        found.stream()
            .filter(each -> !each.isBlank())
            .mapToInt(each -> each.length() - each.stripLeading().length())
            .min()
            .orElse(0);
    return found.stream()
        .map(each -> each.isBlank() ? "" : each.substring(left))
        .collect(Collectors.joining("\n"))
        .strip();
  }
}
