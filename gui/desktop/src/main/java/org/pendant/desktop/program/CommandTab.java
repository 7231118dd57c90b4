package org.pendant.desktop.program;

import java.awt.CardLayout;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;
import javax.swing.JPanel;
import org.pendant.desktop.program.form.NodeForms;
import org.pendant.project.program.ProgramNode;

/**
 * Command tab: the selected node: its form, what can be done with several, or what is known of a
 * foreign one.
 */
@SuppressWarnings("serial") // never written to a stream
final class CommandTab extends JPanel {
  private static final String ONE = "one";
  private static final String SEVERAL = "several";
  private static final String FOREIGN = "foreign";

  private final CardLayout cards = new CardLayout();
  private final transient Supplier<NodeForms> maker;
  private transient Optional<NodeForms> forms = Optional.empty();
  private final SeveralPane several;
  private final ForeignPane foreign = new ForeignPane();
  private boolean isForeign;

  /**
   * Shows nothing yet.
   *
   * @param maker makes the forms of nodes, when a program of nodes is shown for the first time
   */
  CommandTab(Supplier<NodeForms> maker, TreeCommands commands) {
    this.maker = maker;
    several = new SeveralPane(commands);
    setLayout(cards);
    add(several, SEVERAL);
    add(foreign, FOREIGN);
  }

  /**
   * Shows what is selected.
   *
   * @param count how many nodes that are
   * @param one the node if it is one
   * @param lead the key of the one that was chosen last
   */
  void show(
      Optional<TreeProgram> program, int count, Optional<ProgramNode> one, OptionalLong lead) {
    isForeign = program.filter(each -> each.document().readOnly()).isPresent();
    if (isForeign) {
      foreign.show(program.orElseThrow(), lead);
      cards.show(this, FOREIGN);
    } else if (count > 1) {
      several.show(count);
      cards.show(this, SEVERAL);
    } else {
      forms().show(one);
      cards.show(this, ONE);
    }
  }

  /** Puts the keys into the field that a problem is about, or into the first one. */
  void focus(String field) {
    if (isForeign) {
      foreign.focus();
    } else {
      forms().focus(field);
    }
  }

  private NodeForms forms() {
    if (forms.isEmpty()) {
      forms = Optional.of(maker.get());
      add(forms.get().component(), ONE);
    }
    return forms.get();
  }
}
