package org.pendant.sweep.run;

import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.language.source.Source;
import org.pendant.models.dynamics.Payload;

/**
 * Variant setup: what a variant of a sweep is run with.
 *
 * @param options the controller is switched on with
 * @param program what runs; the very text of the plan's program where the variant changes none
 * @param inputs what happens at the inputs
 * @param slider the speed slider, 0 to 1
 * @param load what truly hangs on the flange; empty for what the scene or the program says
 */
record VariantSetup(
    ControllerOptions options,
    Source program,
    InputWaveforms inputs,
    OptionalDouble slider,
    Optional<Payload> load) {}
