package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.OptionalDouble;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/** Device field: what a device of a kind may have in the file of a scene. */
public sealed interface DeviceField {
  /** Its key in the file. */
  String key();

  /** What people call it. */
  String title();

  /** What it says, in words behind its title. */
  String help();

  /** Whether a device must have it. */
  boolean required();

  /**
   * Yes or no.
   *
   * @param standing what holds where a file says nothing
   */
  record Flag(String key, String title, String help, boolean standing) implements DeviceField {
    @Override
    public boolean required() {
      return false;
    }
  }

  /**
   * A number.
   *
   * @param range what it may be, in SI
   * @param standing what holds where a file says nothing; empty for nothing
   * @param whole whether it has no fraction
   * @param without what holds without one that has no standing value, in words
   */
  record Amount(
      String key,
      String title,
      String help,
      Range range,
      OptionalDouble standing,
      boolean required,
      boolean whole,
      String without)
      implements DeviceField {}

  /**
   * An object of the scene, by its name.
   *
   * @param moves whether it has a mass; otherwise it is a box that stands still
   */
  record Subject(String key, String title, String help, boolean moves) implements DeviceField {
    /** What it must be, in words. */
    public String kind() {
      return moves ? text("objectWithMass") : text("standingBox");
    }

    @Override
    public boolean required() {
      return true;
    }
  }

  /**
   * The wire to a digital signal.
   *
   * @param input whether the device sets the signal, which is an input of the controller then; it
   *     watches the signal otherwise
   */
  record Wire(String key, String title, String help, boolean input, boolean required)
      implements DeviceField {}

  /**
   * A text.
   *
   * @param example one that people begin with
   */
  record Words(String key, String title, String help, String example, boolean required)
      implements DeviceField {}

  /**
   * Numbers by names, such as {@code register[3]}.
   *
   * @param example as people type them
   */
  record Values(String key, String title, String help, String example) implements DeviceField {
    @Override
    public boolean required() {
      return false;
    }
  }

  /**
   * A place in the base frame, three numbers.
   *
   * @param range of each
   */
  record Place(String key, String title, String help, Range range) implements DeviceField {
    @Override
    public boolean required() {
      return true;
    }
  }

  /**
   * Three numbers along the axes of the base that are no place: a way, a direction, a turn.
   *
   * @param range of each
   */
  record Direction(String key, String title, String help, Range range) implements DeviceField {
    @Override
    public boolean required() {
      return true;
    }
  }

  /**
   * Fields of which a device has those of one way, or none.
   *
   * @param ways the first of which may be without fields, and holds where a file has no others
   */
  record Choice(String title, String help, List<Way> ways) implements DeviceField {
    /**
     * One way.
     *
     * @param title what people call it
     * @param mark the key that no other way has; empty for one without fields
     */
    public record Way(String title, String mark, List<DeviceField> fields) {
      /** Copies the list. */
      public Way {
        fields = List.copyOf(fields);
      }
    }

    /** Copies the list. */
    public Choice {
      ways = List.copyOf(ways);
    }

    /** None: the fields of its ways have keys. */
    @Override
    public String key() {
      return "";
    }

    @Override
    public boolean required() {
      return false;
    }
  }

  /**
   * Objects of the scene that have a mass, by their names; all where there is no name.
   *
   * @param most how many
   */
  record Subjects(String key, String title, String help, int most) implements DeviceField {
    @Override
    public boolean required() {
      return false;
    }
  }

  /**
   * A pose, six numbers, which may be left out.
   *
   * @param without what holds without one, in words
   * @param first the pose that people begin with
   * @param position range of the first three
   * @param rotation range of the others
   */
  record Spot(
      String key,
      String title,
      String help,
      String without,
      Pose first,
      Range position,
      Range rotation)
      implements DeviceField {
    @Override
    public boolean required() {
      return false;
    }
  }

  /**
   * Several fields in an object of their own.
   *
   * @param fields none of which must be there
   */
  record Group(String key, String title, String help, List<DeviceField> fields)
      implements DeviceField {
    /** Copies the list. */
    public Group {
      fields = List.copyOf(fields);
    }

    @Override
    public boolean required() {
      return false;
    }
  }
}
