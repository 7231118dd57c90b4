package org.pendant.desktop.scene.view;

import java.awt.event.ActionEvent;
import java.util.function.UnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.pendant.command.service.StandardView;
import org.pendant.desktop.scene.Camera;

/**
 * Camera keys: arrows turn, with shift they move, plus and minus zoom in and out, digits look from
 * the standard directions.
 */
final class CameraKeys {
  private static final double TURN_RAD = Math.toRadians(5);
  private static final double MOVE_PX = 40;
  private static final double STEP = 1.15;

  private final SceneView view;

  private CameraKeys(SceneView view) {
    this.view = view;
  }

  static void bind(SceneView view) {
    CameraKeys keys = new CameraKeys(view);
    keys.turn("LEFT", -TURN_RAD, 0);
    keys.turn("RIGHT", TURN_RAD, 0);
    keys.turn("UP", 0, TURN_RAD);
    keys.turn("DOWN", 0, -TURN_RAD);
    keys.move("LEFT", MOVE_PX, 0);
    keys.move("RIGHT", -MOVE_PX, 0);
    keys.move("UP", 0, MOVE_PX);
    keys.move("DOWN", 0, -MOVE_PX);
    for (String plus : new String[] {"PLUS", "typed +", "ADD"}) {
      keys.on(plus, camera -> camera.dollied(1 / STEP));
    }
    for (String minus : new String[] {"typed -", "SUBTRACT"}) {
      keys.on(minus, camera -> camera.dollied(STEP));
    }
    for (StandardView direction : StandardView.values()) {
      keys.run(direction.key(), () -> view.look(direction));
    }
    keys.run("N", () -> view.stepMark(1));
    keys.run("shift N", () -> view.stepMark(-1));
    keys.run("O", () -> view.setLens(view.lens().other()));
    keys.run("HOME", view::fit);
    keys.run("ENTER", view::zoomToTool);
  }

  private void turn(String key, double azimuthRad, double elevationRad) {
    on(key, camera -> camera.orbited(azimuthRad, elevationRad));
  }

  private void move(String key, double rightPx, double downPx) {
    on("shift " + key, camera -> camera.panned(rightPx, downPx, view.getHeight()));
  }

  private void on(String key, UnaryOperator<Camera> change) {
    run(key, () -> view.change(change));
  }

  private void run(String key, Runnable action) {
    String name = "scene " + key;
    view.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), name);
    view.getActionMap().put(name, new KeyAction(action));
  }

  private static final class KeyAction extends AbstractAction {
    private static final long serialVersionUID = 1L;

    private final transient Runnable action;

    KeyAction(Runnable action) {
      this.action = action;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
      action.run();
    }
  }
}
