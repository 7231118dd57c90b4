/**
 * Conveyor encoders on two inputs: pulses are decoded, tick counts wrap around and are filtered.
 * Open {@link org.pendant.controller.encoder.Encoders} first.
 */
package org.pendant.controller.encoder;
