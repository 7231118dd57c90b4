package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.WrappingRow;

/** Multiple selection pane: what can be done with several nodes at once. */
@SuppressWarnings("serial") // never written to a stream
final class SeveralPane extends JPanel {
  private final JLabel heading = new JLabel();

  SeveralPane(TreeCommands commands) {
    super(new MigLayout("insets 16, wrap, fillx", "[grow, fill, 0::]"));
    setName("program-several");
    heading.putClientProperty("FlatLaf.styleClass", "h3");
    add(heading);
    JPanel buttons = new JPanel(new WrappingRow(8));
    record Press(String name, String title, Runnable run) {}
    for (Press each :
        List.of(
            new Press("suppress", text("suppressOrUseAgain"), commands::suppress),
            new Press("duplicate", text("duplicate"), commands::duplicate),
            new Press("delete", text("delete"), commands::delete))) {
      JButton button = new JButton(each.title());
      button.setName("program-several-" + each.name());
      button.addActionListener(event -> each.run().run());
      buttons.add(button);
    }
    add(buttons);
  }

  void show(int count) {
    heading.setText(text("nodesAreSelected", count));
  }
}
