package org.pendant.desktop.scene.view;

import org.pendant.controller.world.Vector3;

/** Hand on the arm: pulls it when the user drags it in the picture. */
public interface ArmHand {
  /** A hand that drags nothing. */
  ArmHand NONE =
      new ArmHand() {
        @Override
        public boolean grabs(boolean key) {
          return false;
        }

        @Override
        public void begin(int link, Vector3 pointInLinkM, Vector3 placeInBaseM) {}

        @Override
        public void move(Vector3 placeInBaseM) {}

        @Override
        public void end() {}

        @Override
        public boolean pulls() {
          return false;
        }
      };

  /**
   * Whether a drag that begins on the arm now pulls it, rather than turning the view.
   *
   * @param key whether the key for it is held
   */
  boolean grabs(boolean key);

  /**
   * The arm is held at a point.
   *
   * @param link the link that joint 0 to 5 moves
   * @param pointInLinkM where it is held, in the Denavit-Hartenberg frame after that joint
   * @param placeInBaseM where it is pulled to
   */
  void begin(int link, Vector3 pointInLinkM, Vector3 placeInBaseM);

  /** It is pulled to another place. */
  void move(Vector3 placeInBaseM);

  /** It is let go. */
  void end();

  /** Whether the arm is being pulled: what has begun may have been refused. */
  boolean pulls();
}
