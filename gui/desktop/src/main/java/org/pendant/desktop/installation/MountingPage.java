package org.pendant.desktop.installation;

import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.world.Vector3;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Mounting page: how the base is mounted. */
final class MountingPage implements Page {
  private final Editing editing;
  private final TitledCard card = new TitledCard("Mounting", "[grow, fill]");
  private final PartsForm<Installation> form;
  private final MountingPicture picture = new MountingPicture();
  private final JLabel gravity = new JLabel();

  MountingPage(Editing editing) {
    this.editing = editing;
    form = new PartsForm<>("mounting", editing::whole, editing::takeWhole);
    form.in(editing.measures());
    form.wide(picture);
    form.numberRow(
        "Tilt",
        Measure.DEGREE,
        now -> now.mounting().tiltRad(),
        (before, rad) -> with(before, new BaseMounting(rad, before.mounting().rotationRad())));
    form.numberRow(
        "Rotation",
        Measure.DEGREE,
        now -> now.mounting().rotationRad(),
        (before, rad) -> with(before, new BaseMounting(before.mounting().tiltRad(), rad)));
    form.add("Gravity", gravity);
    form.buttons(preset("Floor", 0), preset("Wall", Math.PI / 2), preset("Ceiling", Math.PI));
    form.note(
        "Tilt of the base about its y axis, then rotation about its own z axis. Gravity is what"
            + " set_gravity is told, along the axes of the base.");
    form.follow(
        now -> {
          picture.show(now.mounting());
          Vector3 g = now.mounting().gravityInBaseMPerS2();
          gravity.setText(
              String.format(Locale.ROOT, "[%.2f, %.2f, %.2f] m/s\u00b2", g.x(), g.y(), g.z()));
        });
    gravity.setName("mounting-gravity");
    card.add(form.component());
  }

  private static Installation with(Installation before, BaseMounting mounting) {
    return before.with(parts -> parts.mounting = mounting);
  }

  private JButton preset(String title, double tiltRad) {
    JButton button = new JButton(title);
    TitledCard.compact(button);
    TitledCard.named(
        button,
        "mounting-" + title.toLowerCase(Locale.ROOT),
        "Mounted on a " + title.toLowerCase(Locale.ROOT));
    button.addActionListener(
        event -> editing.take(parts -> parts.mounting = new BaseMounting(tiltRad, 0)));
    return button;
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    form.show(editing.now());
  }
}
