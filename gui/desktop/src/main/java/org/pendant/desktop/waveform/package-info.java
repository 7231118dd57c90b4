/**
 * Waveforms: what happens at the inputs while a program runs, drawn by hand or taken from a run.
 * Open {@link org.pendant.desktop.waveform.WaveformView} first.
 */
package org.pendant.desktop.waveform;
