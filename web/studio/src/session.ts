/** The connection to the server: messages with ids, answers by id, bytes that follow a message. */

import type { Attachment, Message } from "./protocol";

export type Answer = (message: Message, attachments: readonly Attachment[]) => void;

export interface Socket {
    onopen: (() => void) | null;
    onclose: (() => void) | null;
    onmessage: ((event: { data: unknown }) => void) | null;
    binaryType: string;
    send(data: string): void;
    close(): void;
}

const FIRST_WAIT_MS = 300;
const LONGEST_WAIT_MS = 4000;

const TYPES = {
    f32: Float32Array,
    u8: Uint8Array,
    u16: Uint16Array,
    u32: Uint32Array,
    f16: Uint16Array, // bits of half floats, as textures take them
} as const;

/** Arrays back to back, each padded to 4 bytes. */
export function unpack(
    layout: readonly Omit<Attachment, "data">[],
    bytes: ArrayBuffer,
): Attachment[] {
    let at = 0;
    return layout.map((part) => {
        const Type = TYPES[part.dtype];
        const count = part.shape.reduce((product, n) => product * n, 1);
        const data = new Type(bytes, at, count);
        at += Math.ceil(data.byteLength / 4) * 4;
        return { ...part, data };
    });
}

export class Session {
    private socket: Socket | null = null;
    private open = false;
    private closed = false;
    private nextId = 1;
    private wait = FIRST_WAIT_MS;
    private readonly answers = new Map<number, Answer>();
    private awaiting: Message | null = null;

    /**
     * @param connect  makes a socket
     * @param onChange  told when the server is there, and when it has gone
     * @param onUnread  told why the server could not read a message
     */
    constructor(
        private readonly connect: () => Socket,
        private readonly onChange: (open: boolean) => void,
        private readonly onUnread: (why: string) => void = () => undefined,
    ) {
        this.begin();
    }

    get isOpen(): boolean {
        return this.open;
    }

    /** @return the id, under which `answer` is called for each message about it until forget() */
    send(type: string, fields: Readonly<Record<string, unknown>>, answer: Answer): number {
        const id = this.nextId++;
        this.answers.set(id, answer);
        // A socket that is not open yet takes nothing.
        if (this.open) this.socket?.send(JSON.stringify({ type, id, ...fields }));
        return id;
    }

    /** No more answers are wanted. */
    forget(id: number): void {
        this.answers.delete(id);
    }

    /** Something that nobody answers. */
    tell(type: string, fields: Readonly<Record<string, unknown>>): void {
        if (this.open) this.socket?.send(JSON.stringify({ type, ...fields }));
    }

    close(): void {
        this.closed = true;
        this.socket?.close();
    }

    private begin(): void {
        const socket = this.connect();
        this.socket = socket;
        socket.binaryType = "arraybuffer";
        socket.onopen = () => {
            this.open = true;
            this.wait = FIRST_WAIT_MS;
            this.onChange(true);
        };
        socket.onclose = () => {
            this.open = false;
            this.awaiting = null;
            this.answers.clear();
            if (this.closed) return;
            this.onChange(false);
            setTimeout(() => {
                this.begin();
            }, this.wait);
            this.wait = Math.min(2 * this.wait, LONGEST_WAIT_MS);
        };
        socket.onmessage = ({ data }) => {
            this.receive(data);
        };
    }

    private receive(data: unknown): void {
        if (typeof data === "string") {
            const message = JSON.parse(data) as Message;
            if (Array.isArray(message.binary)) this.awaiting = message;
            else this.deliver(message, []);
        } else if (data instanceof ArrayBuffer && this.awaiting !== null) {
            const message = this.awaiting;
            this.awaiting = null;
            this.deliver(message, unpack(message.binary as Omit<Attachment, "data">[], data));
        }
    }

    private deliver(message: Message, attachments: readonly Attachment[]): void {
        const { id } = message;
        if (typeof id === "number") this.answers.get(id)?.(message, attachments);
        else if (message.type === "error") this.failAll(message);
    }

    /** A message was refused before its id was read: any that waits may be the one, and none is to wait for ever. */
    private failAll(error: Message): void {
        this.onUnread(String(error.message));
        for (const id of [...this.answers.keys()]) this.answers.get(id)?.({ ...error, id }, []);
    }
}
