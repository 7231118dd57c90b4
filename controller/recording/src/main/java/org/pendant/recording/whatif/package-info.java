/**
 * What if: runs a program once more from a moment of its run with another speed, load or text, each
 * time in a controller of its own, and tells what came of it. Open {@link
 * org.pendant.recording.whatif.VariantRun} first.
 */
package org.pendant.recording.whatif;
