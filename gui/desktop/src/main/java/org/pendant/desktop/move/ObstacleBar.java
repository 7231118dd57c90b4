package org.pendant.desktop.move;

import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;

/** Obstacle bar: tells why the arm cannot be moved, with the button that changes it. */
@SuppressWarnings("serial") // never written to a stream
final class ObstacleBar extends JPanel {
  private final MovePresenter presenter;
  private final Remark text = new Remark("move-obstacle", Palette::warning);
  private final JButton remedy = new JButton();
  private Optional<Obstacle> shown = Optional.empty();

  ObstacleBar(MovePresenter presenter) {
    super(new MigLayout("insets 8 16 8 16, gap 16, hidemode 3", "[grow, fill][]"));
    this.presenter = presenter;
    setName("move-obstacle-bar");
    setBackground(Palette.tint(Palette.warning(), 0.12));
    add(text, "wmin 0, aligny center");
    add(remedy, "aligny center");
    remedy.addActionListener(event -> presenter.removeObstacle());
    setVisible(false);
  }

  void refresh() {
    Optional<Obstacle> obstacle = presenter.obstacle();
    if (obstacle.equals(shown)) {
      return;
    }
    shown = obstacle;
    setVisible(obstacle.isPresent());
    if (obstacle.isPresent()) {
      text.say(obstacle.get().text());
      remedy.setText(obstacle.get().remedy());
      TitledCard.named(remedy, "move-remedy", obstacle.get().text());
      remedy.setVisible(!obstacle.get().remedy().isEmpty());
      remedy.setEnabled(obstacle.get().command().isPresent());
    }
  }
}
