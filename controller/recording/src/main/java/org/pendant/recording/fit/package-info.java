/** What recordings of an arm say of its drives and of what it carried. */
package org.pendant.recording.fit;
