package org.pendant.desktop.scene.view;

import org.pendant.controller.world.Vector3;

/** Hand on an object of the scene: places it when the user drags it in the picture. */
public interface ObjectHand {
  /** A hand that drags nothing. */
  ObjectHand NONE =
      new ObjectHand() {
        @Override
        public boolean grabs() {
          return false;
        }

        @Override
        public boolean begin(String name) {
          return false;
        }

        @Override
        public void move(Vector3 wayInBaseM, boolean fine) {}

        @Override
        public void end() {}
      };

  /** Whether a drag that begins on an object now moves it, rather than turning the view. */
  boolean grabs();

  /** An object is held. Answers whether it can be moved. */
  boolean begin(String name);

  /**
   * It is dragged.
   *
   * @param wayInBaseM from where it was held, m
   * @param fine whether it goes just there, and not in steps
   */
  void move(Vector3 wayInBaseM, boolean fine);

  /** It is let go. */
  void end();
}
