package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.action.Actions;
import org.pendant.kit.theme.HtmlLabel;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;

/** Empty pane: says what will be here while the program in front is a script. */
@SuppressWarnings("serial") // never written to a stream
final class EmptyPane extends JPanel {
  private final JLabel text = new HtmlLabel(SwingConstants.CENTER);

  EmptyPane(Actions actions) {
    super(new MigLayout("fill, wrap, insets 24", "[center]", "push[][]push"));
    setName("program-empty");
    add(text, "wmin 0");
    JPanel buttons = new JPanel(new MigLayout("insets 0, gap 8"));
    for (List<String> each :
        List.of(
            List.of("file.new", text("newProgram")),
            List.of("file.open", text("openProgram")),
            List.of("view.script", text("showTheScript")))) {
      JButton button = new JButton(each.get(1));
      button.setName("program-empty-" + each.get(0).replace('.', '-'));
      button.addActionListener(event -> actions.run(each.get(0)));
      buttons.add(button);
    }
    add(buttons);
  }

  void show(String name) {
    text.setForeground(Palette.quiet());
    text.setText(text("isAScript", Markup.escaped(name)));
  }
}
