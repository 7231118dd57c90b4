package org.pendant.desktop.scene.view;

import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.DeviceHandles;

/** Hand on objects and devices of the scene: places them when they are dragged in the picture. */
public interface ObjectHand {
  /** A hand that drags nothing. */
  ObjectHand NONE =
      new ObjectHand() {
        @Override
        public boolean grabs(boolean key) {
          return false;
        }

        @Override
        public boolean begin(String name, Vector3 pointInBaseM) {
          return false;
        }

        @Override
        public boolean begin(DeviceHandles.Handle handle) {
          return false;
        }

        @Override
        public void move(Vector3 wayInBaseM, boolean fine) {}

        @Override
        public String words() {
          return "";
        }

        @Override
        public void end() {}
      };

  /**
   * Whether a drag that begins on an object now moves it, rather than turning the view.
   *
   * @param key whether the key with which the arm is dragged is held
   */
  boolean grabs(boolean key);

  /** Whether devices can be held at handles now. */
  default boolean hasHandles() {
    return grabs(false);
  }

  /**
   * Whether what is held goes with the pointer in the plane of the picture; along the floor, or up
   * and down, otherwise.
   */
  default boolean freely() {
    return false;
  }

  /**
   * An object is held. Answers whether it can be moved.
   *
   * @param pointInBaseM where, m
   */
  boolean begin(String name, Vector3 pointInBaseM);

  /** A device is held. Answers whether it can be moved. */
  boolean begin(DeviceHandles.Handle handle);

  /**
   * It is dragged.
   *
   * @param wayInBaseM from where it was held, m
   * @param fine whether it goes just there, and not in steps
   */
  void move(Vector3 wayInBaseM, boolean fine);

  /** Where what is held is now, for people; empty for nothing. */
  String words();

  /** It is let go. */
  void end();
}
