package org.pendant.gui.shell;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.layout.WrappingRow;
import org.pendant.gui.move.GhostArm;
import org.pendant.gui.scene.SceneModel;
import org.pendant.gui.scene.StandardView;
import org.pendant.gui.scene.Theme;
import org.pendant.gui.scene.Touching;
import org.pendant.gui.scene.TraceRing;
import org.pendant.gui.scene.view.SceneView;
import org.pendant.gui.workbench.Action;
import org.pendant.gui.workbench.Palette;
import org.pendant.gui.workbench.View;
import org.pendant.gui.workbench.Workbench;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/** The arm in 3D, what is around it, and where its tool has been. */
final class ScenePanel implements View, GhostArm {
  /** Points of the tool's way that are remembered. */
  private static final int TRACE_POINTS = 4000;

  private final Workbench workbench;
  private final SceneView picture = new SceneView();
  private final JPanel panel = new JPanel(new BorderLayout());
  private final TraceRing trace = new TraceRing(TRACE_POINTS);
  private Optional<Joints> ghostRad = Optional.empty();
  private Optional<ArmDescription> arm = Optional.empty();
  private Optional<Touching> touching = Optional.empty();

  ScenePanel(Workbench workbench) {
    this.workbench = workbench;
    JPanel bar =
        new JPanel(new WrappingRow(4)) {
          private static final long serialVersionUID = 1L;

          @Override
          public void updateUI() {
            super.updateUI();
            setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.line()));
          }
        };
    for (StandardView direction : StandardView.values()) {
      String word = direction.name().toLowerCase(Locale.ROOT);
      String title = word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
      offer(bar, "scene." + word, title, "3D: look from: " + word, () -> picture.look(direction));
    }
    offer(bar, "scene.fit", "Fit", "3D: show the whole robot", picture::fit);
    offer(bar, "scene.tool", "Tool", "3D: look at the tool from near by", picture::zoomToTool);
    workbench
        .actions()
        .add(Action.of("scene.clear", "3D: forget where the tool was", "", trace::clear));
    panel.add(bar, BorderLayout.NORTH);
    panel.add(picture, BorderLayout.CENTER);
  }

  private void offer(JPanel bar, String id, String title, String describes, Runnable run) {
    workbench.actions().add(Action.of(id, describes, "", run));
    JButton button = new JButton(title);
    button.setName(id.replace('.', '-'));
    button.setToolTipText(describes);
    button.getAccessibleContext().setAccessibleName(describes);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.addActionListener(event -> run.run());
    bar.add(button);
  }

  @Override
  public String id() {
    return "scene";
  }

  @Override
  public String title() {
    return "3D";
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(Optional<Joints> goalRad) {
    ghostRad = goalRad;
  }

  @Override
  public void refresh(ControllerState state) {
    ArmState now = state.arm();
    ArmDescription shown = arm();
    trace.add(now, state.timeS());
    picture.setModel(
        new SceneModel(
            shown,
            now.kinematics(),
            now.actualPositionRad(),
            ghostRad,
            now.tool().inFlange(),
            List.of(),
            workbench.session().options().scene(),
            touching
                .orElseThrow()
                .names(now.kinematics(), now.actualPositionRad(), now.tool().inFlange()),
            trace.trace(),
            Palette.dark() ? Theme.DARK : Theme.LIGHT));
  }

  /** The arm of the session, which people may change at any time. */
  private ArmDescription arm() {
    String id = workbench.session().options().robotId();
    if (arm.isEmpty() || !arm.get().id().equals(id)) {
      arm = Optional.of(ArmLibrary.load(id));
      touching = Optional.of(new Touching(workbench.session().options().scene()));
      trace.clear();
    }
    return arm.get();
  }
}
