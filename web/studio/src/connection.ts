/** The server, as it comes, goes and comes again: what it is told anew, and what waits until it is there. */

import type { Document } from "./edit";
import { messageOf } from "./errors";
import { MOST_NAME, textTooLarge } from "./files";
import type { RecipeMessage, Standard } from "./protocol";
import type { Schema } from "./schema";
import type { Answer, Socket } from "./session";
import { Session } from "./session";
import type { State } from "./state";
import type { Store } from "./store";

/** The text of paints that have none of their own. */
const WITHOUT_COMMENTS = "ior = 1.5\n[[layer]]\nthickness_um = 1\n";

/** A standard's text; no csv: none. */
interface StandardText {
    readonly csv: string | null;
    readonly name: string;
}

/** A recipe's text; without a name where it comes from no file. */
interface OpenedText {
    readonly toml: string;
    readonly name: string | undefined;
}

export interface Server {
    readonly connect: () => Socket;
    readonly schema: () => Promise<Schema>;
    /** Whether what answers refuses this page's token. */
    readonly refused: () => Promise<boolean>;
}

/** What the page does when something is heard of the server. */
export interface Follower {
    /** It is there, and says what a paint has. */
    begin(schema: Schema): void;
    /** It is there for the first time, and no text waits for it. */
    start(schema: Schema): void;
    /** It is there again, and has been told the standard. */
    back(): void;
    /** No answer will come. */
    lost(): void;
    /** A text that was read. */
    opened(document: Document): void;
    /** @param isNew  not only told again */
    standardTaken(standard: Standard | null, isNew: boolean): void;
}

export class Connection {
    readonly session: Session;
    /** The standard that the server took last, and what it has yet to answer for. */
    private standardText: StandardText | null = null;
    private standardAsked: StandardText | null = null;
    /** The text that the server knows as opened, and one that it has yet to answer for. */
    private openedText: string | null = null;
    private toOpen: OpenedText | null = null;
    /** Told when what was asked will not be answered, by the id of the question. */
    private readonly unanswered = new Map<number, () => void>();
    private begun = false;

    constructor(
        private readonly server: Server,
        private readonly store: Store<State>,
        private readonly follower: Follower,
    ) {
        this.session = new Session(
            server.connect,
            (open) => {
                if (open) void this.connected();
                else this.disconnected();
            },
            (why) => {
                this.store.set({ notice: `The server did not read what it was sent: ${why}` });
            },
        );
    }

    get isOpen(): boolean {
        return this.session.isOpen;
    }

    private async connected(): Promise<void> {
        let schema: Schema;
        try {
            schema = this.store.get().schema ?? (await this.server.schema());
            this.store.set({ connection: "open", schema });
            this.follower.begin(schema);
        } catch (error) {
            const notice = `The server does not say what a paint has: ${messageOf(error)}`;
            this.store.set({ notice });
            return;
        }
        const again = this.standardAsked;
        if (this.standardText !== null) this.sendStandard(this.standardText);
        if (again !== null) this.sendStandard(again);
        const isFirst = !this.begun;
        this.begun = true;
        if (!isFirst) this.follower.back();
        if (this.toOpen !== null) this.openText(this.toOpen.toml, this.toOpen.name);
        else if (isFirst) this.follower.start(schema);
    }

    private disconnected(): void {
        void this.server.refused().then((refused) => {
            if (refused && !this.isOpen) this.store.set({ connection: "refused" });
        });
        this.openedText = null;
        for (const tell of this.unanswered.values()) tell();
        this.unanswered.clear();
        const { connection } = this.store.get();
        this.store.set({ connection: connection === "refused" ? "refused" : "gone" });
        this.follower.lost();
    }

    // ---- texts of paints ----

    /** A text that was typed, dropped or chosen; a faulty one changes nothing and is said. */
    openText(toml: string, name?: string): void {
        const large = textTooLarge(name ?? "The text", toml);
        if (large !== null) {
            this.store.set({ notOpened: large });
            return;
        }
        const asked = { toml, name: name?.slice(-MOST_NAME) };
        this.toOpen = asked; // when there is a server
        if (!this.isOpen) return;
        const id = this.session.send("open", asked, (message) => {
            this.session.forget(id);
            if (this.toOpen === asked) this.toOpen = null;
            if (message.type === "error") {
                this.store.set({ notOpened: String(message.message) });
                return;
            }
            const recipe = (message as unknown as RecipeMessage).tree;
            this.openedText = toml;
            this.follower.opened({ recipe, locks: new Set(), toml });
        });
    }

    /** Another paint takes the place of a text that waits. */
    openNothing(): void {
        this.toOpen = null;
    }

    /**
     * Before the server is asked about a paint: undo may have gone back to one of another text, whose comments
     * are to be kept. One of a link has no text: it must not take those of the text before it.
     */
    tellTextOf(document: Document): void {
        const text = document.toml ?? WITHOUT_COMMENTS;
        if (text === this.openedText) return;
        this.openedText = text;
        const id = this.session.send("open", { toml: text }, () => {
            this.session.forget(id);
        });
    }

    // ---- the standard ----

    setStandard(csv: string | null, name: string): void {
        const large = csv === null ? null : textTooLarge(name, csv);
        if (large !== null) {
            this.store.set({ notice: large });
            return;
        }
        this.standardAsked = { csv, name };
        this.sendStandard(this.standardAsked);
    }

    private sendStandard(asked: StandardText): void {
        if (!this.isOpen) return; // when there is a server
        const { csv, name } = asked;
        const { model } = this.store.get().settings;
        const id = this.session.send("standard", { csv, name, model }, (message) => {
            this.session.forget(id);
            const isNew = asked === this.standardAsked;
            if (isNew) this.standardAsked = null;
            if (message.type === "error") {
                const notice = `The standard cannot be used: ${String(message.message)}`;
                this.store.set({ notice });
                return;
            }
            this.standardText = csv === null ? null : asked;
            const standard = csv === null ? null : (message as unknown as Standard);
            this.follower.standardTaken(standard, isNew);
        });
    }

    // ---- other questions ----

    /**
     * One question, one answer.
     * @param progress  told how far it is meanwhile
     * @param lost  told when the server goes away before it has answered
     * @return whether there was somebody to ask
     */
    ask(
        type: string,
        fields: Readonly<Record<string, unknown>>,
        answer: Answer,
        progress: (fraction: number) => void = () => undefined,
        lost: () => void = () => undefined,
    ): boolean {
        if (!this.isOpen) return false;
        const id = this.session.send(type, fields, (message, attachments) => {
            if (message.type === "progress") {
                progress(Number(message.fraction));
                return;
            }
            this.session.forget(id);
            this.unanswered.delete(id);
            answer(message, attachments);
        });
        this.unanswered.set(id, lost);
        return true;
    }
}
