package org.pendant.controller.box;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.pendant.script.value.Value;

/**
 * Published state: what the controller reported to its clients at the end of the frame before, for
 * programs to read.
 */
public interface Published {
  /** The output field that tells how long the computer worked at a frame. */
  String EXECUTION_TIME = "actual_execution_time";

  /** The input field with the readings of an external force/torque sensor. */
  String EXTERNAL_FORCE_TORQUE = "external_force_torque";

  /** A box that no thread drives has reported nothing. */
  Published NOTHING =
      new Published() {
        @Override
        public Optional<Value> field(String name) {
          return Optional.empty();
        }

        @Override
        public Collection<String> fieldNames() {
          return List.of();
        }

        @Override
        public boolean takesInput(String name) {
          return false;
        }

        @Override
        public Optional<Integer> portRegister(int address) {
          return Optional.empty();
        }

        @Override
        public Optional<Boolean> portBit(int address) {
          return Optional.empty();
        }
      };

  /** The value of an RTDE output field; empty if there is no such field (manual 18.10). */
  Optional<Value> field(String name);

  /** The names of all RTDE output fields. */
  Collection<String> fieldNames();

  /** Whether {@code name} is an RTDE input field. */
  boolean takesInput(String name);

  /** A register as Modbus clients see it, 0 to 65535; empty if there is none. */
  Optional<Integer> portRegister(int address);

  /** A bit as Modbus clients see it; empty if there is none. */
  Optional<Boolean> portBit(int address);
}
