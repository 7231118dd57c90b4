package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.awt.Insets;
import javax.swing.JTabbedPane;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.editor.Execution;
import org.pendant.language.signature.Catalogue;
import org.pendant.project.program.script.GeneratedScript;

/** Node tabs: what stands beside the tree: the selected node, the script, and the variables. */
@SuppressWarnings("serial") // never written to a stream
final class NodeTabs extends JTabbedPane {
  private final CommandTab command;
  private final ScriptPreview preview;
  private final ValuesPane values = new ValuesPane();

  /**
   * All three.
   *
   * @param shown told when another of them is in front
   */
  NodeTabs(CommandTab command, Catalogue catalogue, Runnable shown) {
    this.command = command;
    preview = new ScriptPreview(catalogue);
    setName("program-tabs");
    // One row in a narrow window, too: rows of tabs would change places when one is chosen.
    setTabLayoutPolicy(SCROLL_TAB_LAYOUT);
    putClientProperty("JTabbedPane.tabInsets", new Insets(4, 6, 4, 6));
    putClientProperty("JTabbedPane.scrollButtonsPolicy", "never");
    putClientProperty("JTabbedPane.tabsPopupPolicy", "asNeeded");
    getAccessibleContext().setAccessibleName(text("nodeScriptAndVariables"));
    addTab(text("command"), command);
    addTab(text("script"), preview);
    addTab(text("variables"), values);
    addChangeListener(event -> shown.run());
  }

  CommandTab command() {
    return command;
  }

  /** Lets keys go to a field of the node's form; empty text for the first. */
  void focusForm(String field) {
    setSelectedComponent(command);
    command.focus(field);
  }

  /** Shows the variables of a program. */
  void showVariables(TreeProgram program) {
    values.show(program.tree(), program.installation().variables());
  }

  /** Shows a script, if that is in front, and marks a node of it; 0 for none. */
  void showScript(GeneratedScript script, long node) {
    if (getSelectedComponent() == preview) {
      preview.show(script, node);
    }
  }

  /** Shows a snapshot; the line that runs stays in sight if {@code follow} is true. */
  void refresh(ControllerState state, Execution execution, boolean follow) {
    if (getSelectedComponent() == preview) {
      preview.setExecution(execution, follow);
    }
    if (values.isShowing()) {
      values.refresh(state.variables());
    }
  }
}
